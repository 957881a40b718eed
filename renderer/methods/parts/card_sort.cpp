#include "renderer/methods/parts/card_sort.h"

#include "renderer/radix_sort.h"

namespace plume::card_sort {

void add_needs(Needs& needs, const Transparents& transparents) {
  const uint64_t count = std::max(transparents.count, 1u);
  needs.buffers.push_back({.name = "pairs", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back({.name = "scratch", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back({.name = "counts", .bytes = radix_counts_bytes(transparents.count), .clear = {}});
  needs.buffers.push_back({.name = "order", .bytes = count * 4, .clear = {}});
}

void record(const Picture& picture) {
  picture.frame.pass("sort", [&](gpu::Pass& pass) {
    if (picture.transparents.count > 0) record_by_depth(pass, picture);
  });
}

void record_by_depth(gpu::Pass& pass, const Picture& picture) {
  const Transparents& transparents = picture.transparents;
  const uint32_t count = transparents.count;
  pass.dispatch(pass.pipelines().compute("methods/sorted/keys.comp"),
                {{"View", transparents.view},
                 {"Cards", transparents.cards},
                 {"Pairs", &picture.resources.buffer("pairs")}},
                count, {gpu::groups(count, 256), 1, 1});
  pass.barrier();
  record_pairs(pass, picture);
}

void record_pairs(gpu::Pass& pass, const Picture& picture) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const uint32_t count = picture.transparents.count;
  radix_sort(pass, *buffer("pairs"), *buffer("scratch"), *buffer("counts"), count);
  pass.dispatch(pass.pipelines().compute("methods/sorted/order.comp"),
                {{"Pairs", buffer("pairs")}, {"Order", buffer("order")}}, count,
                {gpu::groups(count, 256), 1, 1});
}

}  // namespace plume::card_sort
