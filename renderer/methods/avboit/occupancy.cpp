#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_occupancy_needs(Needs& needs, const Plan& plan) {
  const uint64_t masks = plan.tiles() * shared::kMaskWords * 4;
  needs.buffers.push_back({.name = "occupancy", .bytes = 2 * masks, .clear = 0});
}

void record_occupancy(const Picture& picture, const Plan& plan) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Transparents& transparents = picture.transparents;
  const gpu::Binding volume{"VolumeBlock", buffer("volume")}, occupancy{"Occupancy", buffer("occupancy")};
  picture.frame.pass("occupancy", [&](gpu::Pass& pass) {
    gpu::Bindings bindings = transparents.seen();
    bindings.insert(
        bindings.end(),
        {volume, occupancy, {"LayersStart", buffer("layers_start")}, {"WarpTable", buffer("warp")}});
    pass.dispatch(pass.pipelines().compute("methods/avboit/occupancy.comp"), bindings, 0u,
                  transparents.each_seen());
  });
  picture.frame.pass("clear_extinction", [&](gpu::Pass& pass) {
    pass.dispatch(
        pass.pipelines().compute("methods/avboit/clear.comp", {plan.settings.sparse ? 1u : 0u,
                                                               plan.settings.lane_bits(), plan.rgb_words()}),
        {volume,
         occupancy,
         {"Extinction", buffer("extinction")},
         {"ExtinctionRgb", buffer("extinction_rgb")}},
        0u, {plan.volume.tiles.x, plan.volume.tiles.y, 1});
  });
}

}  // namespace plume::avboit
