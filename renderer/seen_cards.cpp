#include "renderer/seen_cards.h"

#include "renderer/radix_sort.h"
#include "shaders/shared/draw_command.h"

namespace plume {
namespace {

gpu::Buffer buffer_of(gpu::Device& device, const char* label, uint64_t bytes) {
  return gpu::Buffer(device, {.owner = "scene", .label = label, .bytes = bytes});
}

constexpr shared::BadCards kNoneBad{.count = 0, .first = ~0u};

}  // namespace

SeenCards::SeenCards(gpu::Device& device)
    : device_(device),
      all_(buffer_of(device, "all cards", sizeof(shared::Workload))),
      seen_(buffer_of(device, "seen cards", sizeof(shared::Workload))),
      draws_(buffer_of(device, "seen draws", (1 + kSources) * sizeof(shared::DrawCommand))),
      bad_(
          device,
          {.owner = "scene", .label = "bad cards", .bytes = sizeof(shared::BadCards), .host_visible = true}) {
  bad_.mapped<shared::BadCards>()[0] = kNoneBad;
}

void SeenCards::fit(Transparents& transparents) {
  if (transparents.count > capacity_ || !order_) {
    capacity_ = std::max(transparents.count + transparents.count / 4, 64u);
    pairs_ = buffer_of(device_, "seen pairs", uint64_t(capacity_) * 8);
    sorted_pairs_ = buffer_of(device_, "seen pairs, sorted", uint64_t(capacity_) * 8);
    counts_ = buffer_of(device_, "seen counts", radix_counts_bytes(capacity_));
    order_ = buffer_of(device_, "order", uint64_t(capacity_) * 4);
  }
  transparents.order = &order_;
  transparents.work = &seen_;
  transparents.draws = &draws_;
}

void SeenCards::record(gpu::Frame& frame, const Transparents& transparents,
                       const gpu::Buffer& submission) const {
  frame.pass("seen cards", [&](gpu::Pass& pass) {
    pass.update(all_, shared::workload_of(transparents.count));
    pass.update(bad_, kNoneBad);
    if (transparents.count == 0) {
      pass.fill(draws_, 0);
      pass.update(seen_, shared::workload_of(0));
      return;
    }
    pass.barrier();
    pass.dispatch(pass.pipelines().compute("surface/seen_keys.comp"),
                  {{"Cards", transparents.cards},
                   {"Order", &submission},
                   {"Work", &all_},
                   {"Pairs", &pairs_},
                   {"Bad", &bad_}},
                  glm::uvec2(transparents.first(Source::kHaze), transparents.first(Source::kRgb)),
                  each_item(all_));
    pass.barrier();
    radix_round(pass, pairs_, sorted_pairs_, counts_, all_, 0);
    pass.dispatch(pass.pipelines().compute("surface/seen_draws.comp"),
                  {{"Pairs", &sorted_pairs_},
                   {"Counts", &counts_},
                   {"Work", &all_},
                   {"Order", &order_},
                   {"Draws", &draws_},
                   {"Seen", &seen_}},
                  0u, each_item(all_));
  });
}

}  // namespace plume
