// What a scene's effects cost at a tick, and why: awake ones are simulated, the others are a small record on
// the CPU.
#ifndef PLUME_EFFECTS_DEMAND_H
#define PLUME_EFFECTS_DEMAND_H

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace plume {

struct InstanceDemand {
  std::string name;
  bool called = false;
  bool awake = false;  ///< it is simulated at this tick
  /// One phrase: "has 512 particles", "not called", "starts at tick 120", "finished at tick 900", "between
  /// births", "out of view", "out of view, paused at its tick 40", "frozen at its tick 40".
  std::string why;
  uint64_t ticks_simulated = 0;  ///< by stepping or by seeks: of the emitter that took most
  uint64_t ticks_saved = 0;      ///< that it would have taken besides, had it always been seen
  uint64_t dispatches = 0;       ///< simulation dispatches it took part in
  uint64_t bytes = 0;            ///< of particle state now
  uint64_t bytes_saved = 0;      ///< that it would have besides, were it seen now
};

/// Of several: sums, and awake when any is.
InstanceDemand total(const std::vector<InstanceDemand>& instances);
/// {"instances": [...], "total": {...}}, as results.json and `plume list` give it.
nlohmann::json demand_json(const std::vector<InstanceDemand>& instances);

}  // namespace plume
#endif
