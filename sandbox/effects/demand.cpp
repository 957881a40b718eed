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

namespace {

nlohmann::json costs_json(const InstanceDemand& demand) {
  return {{"ticks_simulated", demand.ticks_simulated},
          {"ticks_saved", demand.ticks_saved},
          {"dispatches", demand.dispatches},
          {"bytes", demand.bytes},
          {"bytes_saved", demand.bytes_saved}};
}

}  // namespace

nlohmann::json demand_json(const std::vector<InstanceDemand>& instances) {
  nlohmann::json list = nlohmann::json::array();
  for (const InstanceDemand& instance : instances) {
    list.push_back(costs_json(instance));
    list.back().update({{"name", instance.name},
                        {"called", instance.called},
                        {"awake", instance.awake},
                        {"why", instance.why}});
  }
  return {{"instances", std::move(list)}, {"total", costs_json(total(instances))}};
}

}  // namespace plume
