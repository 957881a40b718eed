#include "renderer/radix_sort.h"

#include <cstddef>

namespace plume {

uint64_t radix_counts_bytes(uint32_t most_pairs) {
  return std::max<uint64_t>(4, uint64_t(shared::workload_of(most_pairs).tiles.x) * shared::kRadixDigits * 4);
}

void radix_round(gpu::Pass& pass, const gpu::Buffer& from, const gpu::Buffer& to, const gpu::Buffer& counts,
                 const gpu::Buffer& work, uint32_t shift) {
  const gpu::IndirectGroups each_tile{&work, offsetof(shared::Workload, tiles)};
  const gpu::Binding how_many{"Work", &work};
  pass.dispatch(pass.pipelines().compute("sort/count.comp"),
                {{"Source", &from}, {"Counts", &counts}, how_many}, shift, each_tile);
  pass.barrier();
  pass.dispatch(pass.pipelines().compute("sort/scan.comp"), {{"Counts", &counts}, how_many}, 0u, {1, 1, 1});
  pass.barrier();
  pass.dispatch(pass.pipelines().compute("sort/scatter.comp"),
                {{"Source", &from}, {"Counts", &counts}, {"Destination", &to}, how_many}, shift, each_tile);
  pass.barrier();
}

void radix_sort(gpu::Pass& pass, const gpu::Buffer& pairs, const gpu::Buffer& scratch,
                const gpu::Buffer& counts, const gpu::Buffer& work, uint32_t bits) {
  for (uint32_t shift = 0; shift < bits; shift += 8) {  // rounds in twos: the result ends in `pairs`
    radix_round(pass, pairs, scratch, counts, work, shift);
    radix_round(pass, scratch, pairs, counts, work, shift + 4);
  }
}

gpu::IndirectGroups each_item(const gpu::Buffer& work) {
  return {&work, offsetof(shared::Workload, groups)};
}

}  // namespace plume
