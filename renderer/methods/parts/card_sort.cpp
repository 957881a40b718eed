#include "renderer/methods/parts/card_sort.h"

#include <bit>

#include "renderer/radix_sort.h"

namespace plume::card_sort {

void add_needs(Needs& needs, const Transparents& transparents) {
  const uint64_t count = std::max(transparents.count, 1u);
  needs.buffers.push_back({.name = "pairs", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back({.name = "scratch", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back({.name = "counts", .bytes = radix_counts_bytes(transparents.count), .clear = {}});
  needs.buffers.push_back({.name = "order", .bytes = count * 4, .clear = {}});
}

void record(const Picture& picture, Key key) {
  picture.frame.pass("sort", [&](gpu::Pass& pass) { record_order(pass, picture, key); });
}

void record_order(gpu::Pass& pass, const Picture& picture, Key key) {
  gpu::Bindings bindings = picture.transparents.seen();
  bindings.push_back({"Pairs", &picture.resources.buffer("pairs")});
  const bool by_depth = key == Key::kDepth;
  pass.dispatch(pass.pipelines().compute("methods/sorted/keys.comp", {by_depth ? 1u : 0u}), bindings, 0u,
                picture.transparents.each_seen());
  pass.barrier();
  record_pairs(pass, picture, by_depth ? 32 : uint32_t(std::bit_width(picture.transparents.count)));
}

void record_pairs(gpu::Pass& pass, const Picture& picture, uint32_t bits) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const gpu::Buffer& work = *picture.transparents.work;
  radix_sort(pass, *buffer("pairs"), *buffer("scratch"), *buffer("counts"), work, bits);
  pass.dispatch(pass.pipelines().compute("methods/sorted/order.comp"),
                {{"Pairs", buffer("pairs")}, {"Order", buffer("order")}, {"Work", &work}}, 0u,
                each_item(work));
}

}  // namespace plume::card_sort
