// Stable GPU sort of (key, value) pairs by 32-bit keys, ascending; see shaders/sort/radix.h. How many there
// are, only the device need know: it stands in a buffer, as a shared::Workload.
#ifndef PLUME_RENDERER_RADIX_SORT_H
#define PLUME_RENDERER_RADIX_SORT_H

#include "renderer/gpu/frame.h"
#include "shaders/shared/workload.h"

namespace plume {

/// Bytes of the `counts` buffer for at most so many pairs.
uint64_t radix_counts_bytes(uint32_t most_pairs);

/// One round: a stable sort by the four bits of the key from `shift` on, from one buffer into the other.
/// Leaves in `counts` where each digit begins, at [digit * tiles], tiles those of `work`.
void radix_round(gpu::Pass& pass, const gpu::Buffer& from, const gpu::Buffer& to, const gpu::Buffer& counts,
                 const gpu::Buffer& work, uint32_t shift);

/// Sorts pairs of two words in `pairs` by the lowest `bits` of their keys; `scratch` is of the same size. The
/// result is in `pairs`.
void radix_sort(gpu::Pass& pass, const gpu::Buffer& pairs, const gpu::Buffer& scratch,
                const gpu::Buffer& counts, const gpu::Buffer& work, uint32_t bits = 32);

/// Of a list: a work group for every kItemGroup items.
gpu::IndirectGroups each_item(const gpu::Buffer& work);

}  // namespace plume
#endif
