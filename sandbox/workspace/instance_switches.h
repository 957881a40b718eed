// What one switches on instances to look at some of them alone. As a mixer's: a solo silences all that are
// not solo, and what is muted stays so.
#ifndef PLUME_WORKSPACE_INSTANCE_SWITCHES_H
#define PLUME_WORKSPACE_INSTANCE_SWITCHES_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>

namespace plume {

struct InstanceSwitches {
  std::set<size_t> muted, solo;       ///< indices into the scene's instances
  std::map<size_t, uint32_t> frozen;  ///< and the tick after which their time stands still

  /// Those of so many that are not simulated.
  std::set<size_t> silent(size_t instances) const {
    std::set<size_t> result = muted;
    for (size_t i = 0; !solo.empty() && i < instances; ++i)
      if (!solo.contains(i)) result.insert(i);
    return result;
  }
  bool operator==(const InstanceSwitches&) const = default;
};

}  // namespace plume
#endif
