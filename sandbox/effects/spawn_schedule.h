// When the particles of one emitter are born, in integer arithmetic on ticks since the call, so that the
// births of any tick are known without having played the ones before it.
//
// births(t) is the sum of three whole numbers:
// - the bursts up to t;
// - the whole part of the rate's integral over [0, t + 1). The rate is linear between keys; the integral over
//   the last, partly elapsed segment [a, b) of width W with rates R0 at a and R1 at b, x = t + 1 - a, is
//       (R0 x (2W - x) + R1 x^2) / (2W);
// - the whole part of births a metre times the way travelled by t (effects/path.h).
// Each is one exact division: no rounding accumulates and births(t) never decreases.
//
// Children are counted by their roots: an emitter of children has a fixed number of slots for each root
// birth, and all of them are in the window for as long as the root or a child of it can live.
#ifndef PLUME_EFFECTS_SPAWN_SCHEDULE_H
#define PLUME_EFFECTS_SPAWN_SCHEDULE_H

#include <cstdint>
#include <optional>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/effects/path.h"

namespace plume {

/// What decides births besides the emitter's own description.
struct SpawnContext {
  const Path* path = nullptr;       ///< nothing: what is born by distance is not born
  uint32_t stop_tick = UINT32_MAX;  ///< since the call: from this tick on nothing is born
  uint64_t per_root = 1;            ///< slots of children for each birth that Spawn gives
  std::optional<uint32_t> life =
      {};  ///< ticks from a root's birth until no child of it lives; nothing: Spawn's
};

/// A particle born at tick b with life L is alive at ticks b .. b + L - 1. At tick t every living particle is
/// in [first_alive(t), births(t)), numbered by birth. Ticks count from the call; floats are used only on
/// construction.
class SpawnSchedule {
 public:
  static constexpr uint64_t kMaxBirths = UINT32_MAX;

  /// Throws std::invalid_argument when a rate is negative, not finite or above 1e9 a second, when births a
  /// metre are not in 0 .. 1e6, or when keys do not ascend; std::overflow_error, with the number, when more
  /// than kMaxBirths are born.
  explicit SpawnSchedule(const Spawn& spawn, const SpawnContext& context = {});

  /// Particles born at ticks 0 .. tick.
  uint64_t births(uint32_t tick) const;
  /// The tick particle k is born in: the smallest with births(tick) > k; of a child, the tick its root is.
  /// Throws std::out_of_range for k >= births_total().
  uint32_t birth_tick(uint64_t k) const;
  /// Particles that are dead at `tick` whatever their life: born at or before tick - longest life.
  uint64_t first_alive(uint32_t tick) const { return tick < max_life_ ? 0 : births(tick - max_life_); }
  /// At least the maximum over all ticks of births(t) - first_alive(t), and above it by no more than 4 for
  /// each slot of a root; by nothing where there are only bursts.
  uint64_t capacity() const { return capacity_; }
  uint64_t births_total() const { return births_total_; }
  /// The last tick at which anything can be alive; 0 when nothing is ever born.
  uint32_t last_tick() const { return births_total_ == 0 ? 0 : last_birth_tick_ + max_life_ - 1; }

 private:
  __extension__ using Wide = unsigned __int128;
  struct RateKey {
    uint32_t tick;
    uint64_t rate;     // particles a tick, in 2^-20
    Wide area_before;  // twice the integral up to this key, in 2^-20 particles
  };
  struct BurstKey {
    uint32_t tick;
    uint64_t count_until;  // of this burst and all before it
  };
  /// A number of births and the fraction of the next: part over `of` times a power of two that all counts of
  /// a kind share.
  struct Count {
    uint64_t whole = 0;
    Wide part = 0;
    uint32_t of = 1;
  };
  static uint64_t rounded_up(const Count& a, const Count& b);  // a - b

  // Of roots, by the end of a tick; ticks before the call and from the stop on are allowed.
  uint64_t by_bursts(int64_t tick) const;
  Count by_rate(int64_t tick) const;
  Count by_distance(int64_t tick) const;
  uint64_t roots(int64_t tick) const;
  Wide gain(int64_t tick) const;
  uint64_t largest_window() const;

  std::vector<RateKey> rate_;
  std::vector<BurstKey> bursts_;
  std::optional<Path> path_;  // only where births by distance are wanted
  uint64_t per_metre_ = 0;    // in 2^-20
  int64_t last_spawning_tick_ = INT64_MAX;
  uint64_t per_root_ = 1;
  uint32_t max_life_ = 1, last_birth_tick_ = 0;
  uint64_t births_total_ = 0, capacity_ = 0;
};

}  // namespace plume
#endif
