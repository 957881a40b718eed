#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_resolve_needs(Needs& needs, const Plan&) {
  needs.buffers.push_back({.name = "flagged", .bytes = 4, .clear = 0});
}

void record_resolve(const Picture& picture, const Plan& plan) {
  const auto image = [&](const char* name) { return &picture.resources.image(name); };
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Settings& s = plan.settings;
  picture.frame.pass("resolve", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute(
                      "methods/avboit/resolve.comp",
                      {s.normalise ? 1u : 0u, uint32_t(plan.colour()), s.half_particles ? 1u : 0u,
                       s.accumulation == Accumulation::kR11G11B10 ? 0u : 1u, s.skew_guard ? 1u : 0u}),
                  {{"light", image("light")},
                   {"norm", image("norm")},
                   {"norm_rgb", image("norm_rgb")},
                   {"through", image("through")},
                   {"light_half", image("light_half")},
                   {"norm_half", image("norm_half")},
                   {"norm_rgb_half", image("norm_rgb_half")},
                   {"through_half", image("through_half")},
                   {"half_opaque", image("half_opaque")},
                   {"VolumeBlock", buffer("volume")},
                   {"WarpTable", buffer("warp")},
                   {"Layers", buffer("layers")},
                   {"Overlaps", buffer("overlaps")},
                   {"Flagged", buffer("flagged")},
                   {"opaque_depth", &picture.opaque_depth},
                   {"known_light", image("known_light")},
                   {"known_norm", image("known_norm")},
                   {"known_light_half", image("known_light_half")},
                   {"known_norm_half", image("known_norm_half")},
                   {"opaque_color", &picture.opaque_color},
                   {"result", &picture.result}},
                  picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

}  // namespace plume::avboit
