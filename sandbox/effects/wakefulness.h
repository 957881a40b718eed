// Who is awake at a tick, and why: an emitter whose influence nobody sees, or of whom nothing can be alive,
// sleeps. Decided from closed forms alone; nothing is read back from the device.
#ifndef PLUME_EFFECTS_WAKEFULNESS_H
#define PLUME_EFFECTS_WAKEFULNESS_H

#include <functional>
#include <optional>
#include <vector>

#include "sandbox/effects/instances.h"
#include "sandbox/effects/view_volume.h"

namespace plume {

/// All cameras that look at a tick; nothing: everything is seen.
using Views = std::optional<std::vector<ViewVolume>>;
inline const Views kEverything{};
/// Who looks at the ticks that are passed over; nobody moves from `still_from` on.
struct Script {
  std::function<Views(uint32_t tick)> views;
  uint32_t still_from = UINT32_MAX;
};

/// Time passes from tick `before` (nothing: from the beginning) to `tick`. It stands still for what pauses
/// off screen where nobody saw it: by the script, or by `views` where there is none. Going back forgets what
/// came later.
void pass_time(Instances& instances, std::optional<uint32_t> before, uint32_t tick, const Views& views,
               const Script& script);
/// As if no tick had been: no particles are there, nothing has paused, nothing is counted.
void forget(Instances& instances);
/// Notes what is wanted of each emitter at a tick. Returns whether any fell asleep or woke.
bool decide(Instances& instances, uint32_t tick, const Views& views);
/// Adds to each instance's demand what the tick took, and says why. `jumped`: it does not follow the one
/// before.
void count_demand(Instances& instances, uint32_t tick, bool jumped);

}  // namespace plume
#endif
