#include "renderer/methods/avboit/plan.h"
#include "renderer/radix_sort.h"

namespace plume::avboit {
namespace {

/// From (class, card) in the order of submission to an order by class and one indirect draw of each.
void sort_into_draws(gpu::Pass& pass, const Picture& picture, uint32_t count, const char* order,
                     const char* draws) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  pass.barrier();
  radix_round(pass, *buffer("pairs"), *buffer("sorted_pairs"), *buffer("pair_counts"), count, 0);
  pass.dispatch(pass.pipelines().compute("methods/avboit/class_draws.comp"),
                {{"Pairs", buffer("sorted_pairs")},
                 {"Order", buffer(order)},
                 {"Counts", buffer("pair_counts")},
                 {"ClassDraws", buffer(draws)}},
                glm::uvec2(count, radix_tiles(count)), {gpu::groups(count, 256), 1, 1});
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
  const uint32_t count = plan.volume.cards;
  if (count == 0) return;
  picture.frame.pass("sources", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/avboit/sources.comp"),
                  {{"View", picture.transparents.view},
                   {"Cards", picture.transparents.cards},
                   {"Order", picture.transparents.order},
                   {"VolumeBlock", &picture.resources.buffer("volume")},
                   {"Pairs", &picture.resources.buffer("pairs")}},
                  0u, {gpu::groups(count, 256), 1, 1});
    sort_into_draws(pass, picture, count, "source_order", "source_draws");
  });
}

void record_classify(const Picture& picture, const Plan& plan) {
  const uint32_t count = plan.volume.cards;
  if (count == 0) return;
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const bool cull = plan.settings.zero_depth != ZeroDepth::kOff;
  picture.frame.pass("classify", [&](gpu::Pass& pass) {
    pass.dispatch(
        pass.pipelines().compute("methods/avboit/classify.comp", {plan.rgb ? 1u : 0u, cull ? 1u : 0u}),
        {{"View", picture.transparents.view},
         {"Cards", picture.transparents.cards},
         {"Order", picture.transparents.order},
         {"VolumeBlock", buffer("volume")},
         {"WarpTable", buffer("warp")},
         {"RgbStart", buffer("rgb_start")},
         {"LayersStart", buffer("layers_start")},
         {"ZeroDepths", buffer(cull ? "zero_depths" : "rgb_start")},
         {"Pairs", buffer("pairs")}},
        plan.first_coloured, {gpu::groups(count, 256), 1, 1});
    sort_into_draws(pass, picture, count, "class_order", "class_draws");
  });
}

}  // namespace plume::avboit
