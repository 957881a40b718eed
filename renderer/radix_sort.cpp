#include "renderer/radix_sort.h"

#include "shaders/sort/radix.h"

namespace plume {
uint32_t radix_tiles(uint32_t pairs) {
  return gpu::groups(pairs, shared::kRadixTile);
}

uint64_t radix_counts_bytes(uint32_t pairs) {
  return std::max<uint64_t>(4, uint64_t(radix_tiles(pairs)) * shared::kRadixDigits * 4);
}

void radix_round(gpu::Pass& pass, const gpu::Buffer& from, const gpu::Buffer& to, const gpu::Buffer& counts,
                 uint32_t count, uint32_t shift) {
  const uint32_t tiles = radix_tiles(count);
  const shared::RadixPush push{.count = count, .shift = shift, .tiles = tiles};
  pass.dispatch(pass.pipelines().compute("sort/count.comp"), {{"Source", &from}, {"Counts", &counts}}, push,
                {tiles, 1, 1});
  pass.barrier();
  pass.dispatch(pass.pipelines().compute("sort/scan.comp"), {{"Counts", &counts}}, push, {1, 1, 1});
  pass.barrier();
  pass.dispatch(pass.pipelines().compute("sort/scatter.comp"),
                {{"Source", &from}, {"Counts", &counts}, {"Destination", &to}}, push, {tiles, 1, 1});
  pass.barrier();
}

void radix_sort(gpu::Pass& pass, const gpu::Buffer& pairs, const gpu::Buffer& scratch,
                const gpu::Buffer& counts, uint32_t count) {
  if (count == 0) return;
  const gpu::Buffer *from = &pairs, *to = &scratch;
  for (uint32_t shift = 0; shift < 32; shift += 4) {  // an even number of rounds: the result ends in `pairs`
    radix_round(pass, *from, *to, counts, count, shift);
    std::swap(from, to);
  }
}

}  // namespace plume
