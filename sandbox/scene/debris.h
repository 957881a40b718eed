// Opaque particles among the solids of the opaque image: they cover smoke and are covered like walls, with
// sharp edges. No pass where no emitter of them is awake. They throw no shadow on other things.
#ifndef PLUME_SCENE_DEBRIS_H
#define PLUME_SCENE_DEBRIS_H

#include "renderer/frame.h"
#include "sandbox/effects/lighting.h"

namespace plume {

/// Into the depth that solids have been drawn to. Pieces that nothing can be drawn of are left out, and
/// counted in `bad`, a shared::BadCards, where their indices begin with `first_index`.
void record_debris_depth(gpu::Frame& frame, const Targets& targets, const Simulation::Pieces& pieces,
                         const gpu::Buffer& view, const gpu::Buffer& bad, uint32_t first_index);
/// Over the colours of the solids, what `depth`, the opaque depth or something nearer, leaves visible.
void record_debris_color(gpu::Frame& frame, const Targets& targets, const gpu::Image& depth,
                         const Simulation::Pieces& pieces, const gpu::Buffer& view, const gpu::Buffer& solids,
                         const Lighting& lighting);

}  // namespace plume
#endif
