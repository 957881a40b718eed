// What a camera offset does: the particles of an instance's emitters over depth, where they are (outline) and
// where they are drawn (filled), on the slices of depth that the method has.
#ifndef PLUME_DEBUGGER_DEPTH_RULER_H
#define PLUME_DEBUGGER_DEPTH_RULER_H

#include <span>

#include "sandbox/workspace/emitter_depths.h"

namespace plume {

void depth_ruler(std::span<const EmitterDepths> emitters, std::optional<size_t> chosen, float near_m,
                 const std::optional<DepthSlices>& slices);

}  // namespace plume
#endif
