// Stable GPU sort of (key, value) pairs by 32-bit keys, ascending; see shaders/sort/radix.h.
#ifndef PLUME_RENDERER_RADIX_SORT_H
#define PLUME_RENDERER_RADIX_SORT_H

#include "renderer/gpu/frame.h"

namespace plume {

/// Bytes of the `counts` buffer for so many pairs.
uint64_t radix_counts_bytes(uint32_t pairs);

/// Sorts `count` pairs of two words in `pairs`; `scratch` is of the same size. The result is in `pairs`.
void radix_sort(gpu::Pass& pass, const gpu::Buffer& pairs, const gpu::Buffer& scratch,
                const gpu::Buffer& counts, uint32_t count);

}  // namespace plume
#endif
