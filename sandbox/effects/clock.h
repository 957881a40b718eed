// The time of one called instance: ticks since its call, less those at which it stood still, because it was
// frozen by hand or, where its effect says so, because nobody saw it.
#ifndef PLUME_EFFECTS_CLOCK_H
#define PLUME_EFFECTS_CLOCK_H

#include <cstdint>
#include <map>
#include <optional>

namespace plume {

/// Scene ticks between which the time of an instance is stopped by hand: at `until` it still is what it was
/// at `from`.
struct Freeze {
  uint32_t from, until;
  bool operator==(const Freeze&) const = default;
};

class Clock {
 public:
  explicit Clock(uint32_t call_tick) : call_tick_(call_tick) {}

  /// Its own tick at `tick` of the scene; nothing before the call.
  std::optional<uint32_t> local(uint32_t tick) const;
  /// Whether time did not pass from the tick before to this one.
  bool stood_still(uint32_t tick) const;
  /// It stands still at ticks first .. end - 1, as well as where it did already.
  void stand_still(uint32_t first, uint32_t end);
  void freeze(const Freeze& freeze) { stand_still(freeze.from + 1, freeze.until + 1); }
  /// It does not stand still at `tick` or later: what was known of the future is forgotten.
  void forget_from(uint32_t tick);

 private:
  uint32_t call_tick_;
  std::map<uint32_t, uint32_t> standing_;  // first -> end, apart from each other
};

}  // namespace plume
#endif
