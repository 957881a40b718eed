#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_depth_warp_needs(Needs& needs, const Plan&) {
  using namespace shared;
  needs.buffers.push_back({.name = "volume", .bytes = sizeof(Volume), .clear = {}});
  needs.buffers.push_back({.name = "coverage", .bytes = 2 * kMostVirtualSlices / 8, .clear = 0});
  needs.buffers.push_back({.name = "warp",
                           .bytes = sizeof(DepthWarp) + 4 * kMostSlices + 4 * (kMostVirtualSlices + 1),
                           .clear = {}});
}

void record_depth_warp(const Picture& picture, const Plan& plan) {
  const gpu::Binding volume{"VolumeBlock", &picture.resources.buffer("volume")};
  const gpu::Binding coverage{"Coverage", &picture.resources.buffer("coverage")};
  const Transparents& transparents = picture.transparents;
  picture.frame.pass("coverage", [&](gpu::Pass& pass) {
    pass.update(picture.resources.buffer("volume"), plan.volume);
    if (!plan.settings.adaptive) return;
    pass.barrier();
    gpu::Bindings bindings = transparents.seen();
    bindings.insert(bindings.end(), {volume, coverage});
    pass.dispatch(pass.pipelines().compute("methods/avboit/coverage.comp"), bindings, 0u,
                  transparents.each_seen());
  });
  picture.frame.pass("adapt", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/avboit/adapt.comp"),
                  {volume, coverage, {"WarpTable", &picture.resources.buffer("warp")}}, 0u, {1, 1, 1});
  });
}

}  // namespace plume::avboit
