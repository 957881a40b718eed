// When the particles of one emitter are born, in integer arithmetic on ticks since the call, so that the
// births of any tick are known without having played the ones before it.
//
// The rate is linear between keys; births(t) is the whole part of its integral over [0, t + 1) plus the
// bursts up to t. The integral over the last, partly elapsed segment [a, b) of width W with rates R0 at a and
// R1 at b, x = t + 1 - a, is
//     (R0 x (2W - x) + R1 x^2) / (2W),
// so one exact division gives the births: no rounding accumulates and births(t) never decreases.
#ifndef PLUME_EFFECTS_SPAWN_SCHEDULE_H
#define PLUME_EFFECTS_SPAWN_SCHEDULE_H

#include <cstdint>
#include <vector>

#include "sandbox/effects/effect.h"

namespace plume {

/// A particle born at tick b with life L is alive at ticks b .. b + L - 1. At tick t every living particle is
/// in [first_alive(t), births(t)), numbered by birth. Ticks count from the call; floats are used only on
/// construction.
class SpawnSchedule {
 public:
  /// Throws std::invalid_argument when a rate is negative, not finite or above 1e9 a second, or when keys do
  /// not ascend.
  explicit SpawnSchedule(const Spawn& spawn);

  /// Particles born at ticks 0 .. tick.
  uint64_t births(uint32_t tick) const;
  /// The tick particle k is born in: the smallest with births(tick) > k. Throws std::out_of_range for k >=
  /// births_total().
  uint32_t birth_tick(uint64_t k) const;
  /// Particles that are dead at `tick` whatever their life: born at or before tick - longest life.
  uint64_t first_alive(uint32_t tick) const { return tick < max_life_ ? 0 : births(tick - max_life_); }
  /// The maximum over all ticks of births(t) - first_alive(t).
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
  std::vector<RateKey> rate_;
  std::vector<BurstKey> bursts_;
  uint32_t max_life_ = 1, last_birth_tick_ = 0;
  uint64_t births_total_ = 0, capacity_ = 0;
};

}  // namespace plume
#endif
