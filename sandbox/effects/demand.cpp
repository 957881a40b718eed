#include "sandbox/effects/demand.h"

namespace plume {

InstanceDemand total(const std::vector<InstanceDemand>& instances) {
  InstanceDemand sum{.name = "total"};
  for (const InstanceDemand& instance : instances) {
    sum.called |= instance.called;
    sum.awake |= instance.awake;
    sum.ticks_simulated += instance.ticks_simulated;
    sum.ticks_saved += instance.ticks_saved;
    sum.dispatches += instance.dispatches;
    sum.bytes += instance.bytes;
    sum.bytes_saved += instance.bytes_saved;
  }
  return sum;
}

}  // namespace plume
