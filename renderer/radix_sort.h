// Stable GPU sort of (key, value) pairs by 32-bit keys, ascending; see shaders/sort/radix.h.
#ifndef PLUME_RENDERER_RADIX_SORT_H
#define PLUME_RENDERER_RADIX_SORT_H

#include "renderer/gpu/frame.h"

namespace plume {

/// Bytes of the `counts` buffer for so many pairs.
uint64_t radix_counts_bytes(uint32_t pairs);

/// One round: a stable sort by the four bits of the key from `shift` on, from one buffer into the other.
/// Leaves in `counts` where each digit begins, at [digit * radix_tiles(count)].
void radix_round(gpu::Pass& pass, const gpu::Buffer& from, const gpu::Buffer& to, const gpu::Buffer& counts,
                 uint32_t count, uint32_t shift);
uint32_t radix_tiles(uint32_t pairs);

/// Sorts `count` pairs of two words in `pairs`; `scratch` is of the same size. The result is in `pairs`.
void radix_sort(gpu::Pass& pass, const gpu::Buffer& pairs, const gpu::Buffer& scratch,
                const gpu::Buffer& counts, uint32_t count);

}  // namespace plume
#endif
