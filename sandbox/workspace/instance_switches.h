// What one switches on instances to look at some of them alone. As a mixer's: a solo silences all that are
// not solo, and what is muted stays so.
#ifndef PLUME_WORKSPACE_INSTANCE_SWITCHES_H
#define PLUME_WORKSPACE_INSTANCE_SWITCHES_H

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

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
  /// Of the same instances after some came or went: `now` has the new index of each, nothing where it is
  /// gone.
  InstanceSwitches renumbered(const std::vector<std::optional<size_t>>& now) const {
    InstanceSwitches result;
    for (size_t i = 0; i < now.size(); ++i) {
      if (!now[i]) continue;
      if (muted.contains(i)) result.muted.insert(*now[i]);
      if (solo.contains(i)) result.solo.insert(*now[i]);
      if (const auto at = frozen.find(i); at != frozen.end()) result.frozen[*now[i]] = at->second;
    }
    return result;
  }
  bool operator==(const InstanceSwitches&) const = default;
};

}  // namespace plume
#endif
