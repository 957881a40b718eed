#include "renderer/methods/avboit/plan.h"
#include "renderer/radix_sort.h"

namespace plume::avboit {
namespace {

/// From (class, card) in the order of submission to an order by class and one indirect draw of each.
void sort_into_draws(gpu::Pass& pass, const Picture& picture, const char* order, const char* draws) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const gpu::Buffer& work = *picture.transparents.work;
  pass.barrier();
  radix_round(pass, *buffer("pairs"), *buffer("sorted_pairs"), *buffer("pair_counts"), work, 0);
  pass.dispatch(pass.pipelines().compute("methods/avboit/class_draws.comp"),
                {{"Pairs", buffer("sorted_pairs")},
                 {"Order", buffer(order)},
                 {"Counts", buffer("pair_counts")},
                 {"ClassDraws", buffer(draws)},
                 {"Work", &work}},
                0u, each_item(work));
}

}  // namespace

void add_classify_needs(Needs& needs, const Plan& plan) {
  const uint64_t count = std::max(plan.volume.cards, 1u),
                 draws = shared::kClasses * sizeof(shared::DrawCommand);
  needs.buffers.push_back({.name = "pairs", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back({.name = "sorted_pairs", .bytes = count * 8, .clear = {}});
  needs.buffers.push_back(
      {.name = "pair_counts", .bytes = radix_counts_bytes(plan.volume.cards), .clear = {}});
  needs.buffers.push_back({.name = "source_order", .bytes = count * 4, .clear = {}});
  needs.buffers.push_back({.name = "source_draws", .bytes = draws, .clear = 0});
  needs.buffers.push_back({.name = "class_order", .bytes = count * 4, .clear = {}});
  needs.buffers.push_back({.name = "class_draws", .bytes = draws, .clear = 0});
}

void record_sources(const Picture& picture, const Plan& plan) {
  if (plan.volume.cards == 0) return;
  picture.frame.pass("sources", [&](gpu::Pass& pass) {
    gpu::Bindings bindings = picture.transparents.seen();
    bindings.insert(bindings.end(), {{"VolumeBlock", &picture.resources.buffer("volume")},
                                     {"Pairs", &picture.resources.buffer("pairs")}});
    pass.dispatch(pass.pipelines().compute("methods/avboit/sources.comp"), bindings, 0u,
                  picture.transparents.each_seen());
    sort_into_draws(pass, picture, "source_order", "source_draws");
  });
}

void record_classify(const Picture& picture, const Plan& plan) {
  if (plan.volume.cards == 0) return;
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const bool cull = plan.settings.zero_depth != ZeroDepth::kOff;
  picture.frame.pass("classify", [&](gpu::Pass& pass) {
    gpu::Bindings bindings = picture.transparents.seen();
    bindings.insert(bindings.end(), {{"VolumeBlock", buffer("volume")},
                                     {"WarpTable", buffer("warp")},
                                     {"RgbStart", buffer("rgb_start")},
                                     {"LayersStart", buffer("layers_start")},
                                     {"ZeroDepths", buffer(cull ? "zero_depths" : "rgb_start")},
                                     {"Pairs", buffer("pairs")}});
    pass.dispatch(
        pass.pipelines().compute("methods/avboit/classify.comp", {plan.rgb ? 1u : 0u, cull ? 1u : 0u}),
        bindings, plan.first_coloured, picture.transparents.each_seen());
    sort_into_draws(pass, picture, "class_order", "class_draws");
  });
}

}  // namespace plume::avboit
