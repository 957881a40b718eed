// What a scene's effects cost at a tick, and why: awake ones are simulated, the others are a small record on
// the CPU.
#ifndef PLUME_EFFECTS_DEMAND_H
#define PLUME_EFFECTS_DEMAND_H

#include <cstdint>
#include <string>
#include <vector>

namespace plume {

struct InstanceDemand {
  std::string name;
  bool called = false;
  bool awake = false;
  std::string
      why;  ///< one phrase: "has 512 particles", "not called", "starts at tick 120", "finished at tick 900"
  uint64_t ticks_simulated = 0;  ///< by stepping or by seeks: of the emitter that took most
  uint64_t dispatches = 0;       ///< simulation dispatches it took part in
  uint64_t bytes = 0;            ///< of particle state now
};

}  // namespace plume
#endif
