#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_integrate_needs(Needs& needs, const Plan& plan) {
  const uint64_t rays = plan.rays(), nodes = rays * plan.volume.slices;
  needs.buffers.push_back({.name = "integral", .bytes = nodes * 4, .clear = {}});
  needs.buffers.push_back({.name = "integral_rgb", .bytes = plan.rgb ? nodes * 12 : 4, .clear = {}});
  needs.buffers.push_back({.name = "zero_slice", .bytes = rays * 4, .clear = {}});
  needs.buffers.push_back({.name = "rgb_start", .bytes = plan.tiles() * 4, .clear = {}});
}

void record_integrate(const Picture& picture, const Plan& plan) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Settings& s = plan.settings;
  const bool transmittance = s.sampling != Sampling::kSelfExcluded;
  picture.frame.pass("integrate", [&](gpu::Pass& pass) {
    pass.dispatch(
        pass.pipelines().compute("methods/avboit/integrate.comp",
                                 {s.sparse ? 1u : 0u, s.lane_bits(), plan.rgb_words(), transmittance ? 1u : 0u,
                                  transmittance && s.eight_bits ? 1u : 0u}),
        {{"VolumeBlock", buffer("volume")},
         {"WarpTable", buffer("warp")},
         {"Occupancy", buffer("occupancy")},
         {"Extinction", buffer("extinction")},
         {"Overflow", buffer("overflow")},
         {"ExtinctionRgb", buffer("extinction_rgb")},
         {"OverflowRgb", buffer("overflow_rgb")},
         {"Integral", buffer("integral")},
         {"IntegralRgb", buffer("integral_rgb")},
         {"ZeroSlice", buffer("zero_slice")},
         {"RgbStart", buffer("rgb_start")}},
        0u, {plan.volume.tiles.x, plan.volume.tiles.y, 1});
  });
}

}  // namespace plume::avboit
