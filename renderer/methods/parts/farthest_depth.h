// The farthest opaque depth of each cell of pixels: what methods test and feather against that draw at a
// fraction of the picture's resolution.
#ifndef PLUME_METHODS_FARTHEST_DEPTH_H
#define PLUME_METHODS_FARTHEST_DEPTH_H

#include "renderer/methods/method.h"

namespace plume::farthest_depth {

/// Image `farthest`, R32F, reversed depth; `divisor` pixels a cell, each way.
void add_needs(Needs& needs, uint32_t divisor);
/// The pass "farthest".
void record(const Picture& picture, uint32_t divisor);

}  // namespace plume::farthest_depth
#endif
