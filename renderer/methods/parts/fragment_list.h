// Per-pixel linked lists of fragments (Yang et al., "Real-Time Concurrent Linked List Construction on the
// GPU", EGSR 2010): what a method needs that captures fragments before it blends them. Shaders append with
// methods/parts/fragment_list/append.glsl and read with sort.glsl or merge_sort.glsl beside it.
#ifndef PLUME_METHODS_FRAGMENT_LIST_H
#define PLUME_METHODS_FRAGMENT_LIST_H

#include "renderer/methods/method.h"
#include "shaders/methods/parts/fragment_list/fragment_list.h"

namespace plume::fragment_list {

/// Buffers `heads`, `pool` and `nodes`, for so many fragments in the whole picture.
void add_needs(Needs& needs, glm::uvec2 size, uint32_t capacity);
/// Makes the lists empty; a barrier must follow. `extras`: a vec2 for each node, where one is wanted.
void reset(gpu::Pass& pass, const Resources& resources, uint32_t capacity,
           const gpu::Buffer* extras = nullptr);
/// What both shader files bind.
gpu::Bindings bindings(const Resources& resources);
/// The pass "composite": sorts each list by (depth, card) and blends it over the background, which may be the
/// result itself. `redrawn`: a frame whose lists overflowed will be drawn again, and need not be right.
void record_composite(const Picture& picture, const gpu::Image& background, bool redrawn);
/// How full the lists of the last frame were. Waits for the device.
shared::FragmentPool pool(gpu::Device& device, const Resources& resources);
/// For Method::must_redraw(): true when the lists overflowed; then the capacity has grown to hold them.
bool grow(gpu::Device& device, const Resources& resources, uint32_t& capacity);

}  // namespace plume::fragment_list
#endif
