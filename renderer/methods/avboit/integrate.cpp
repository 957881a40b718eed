#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_integrate_needs(Needs& needs, const Plan& plan) {
  const uint64_t rays = plan.rays();
  const uint32_t divisor = plan.volume.divisor, slices = plan.volume.slices;
  constexpr auto usage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled;
  const auto add = [&](const char* name, vk::Format format, bool wanted) {
    needs.images.push_back({.name = name,
                            .format = format,
                            .usage = usage,
                            .divisor = wanted ? divisor : kNowhere,
                            .layers = wanted ? slices : 1});
  };
  add("integral", vk::Format::eR16G16Sfloat, true);
  add("integral_rg", vk::Format::eR16G16B16A16Sfloat, plan.rgb);
  add("integral_b", vk::Format::eR16G16Sfloat, plan.rgb);
  needs.buffers.push_back({.name = "zero_slice", .bytes = rays * 4, .clear = {}});
  needs.buffers.push_back({.name = "rgb_start", .bytes = plan.tiles() * 4, .clear = {}});
}

void record_integrate(const Picture& picture, const Plan& plan) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const Settings& s = plan.settings;
  const bool transmittance = s.sampling != Sampling::kSelfExcluded;
  picture.frame.pass("integrate", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute(
                      "methods/avboit/integrate.comp",
                      {s.sparse ? 1u : 0u, s.lane_bits(), plan.rgb_words(), transmittance ? 1u : 0u,
                       transmittance && s.eight_bits ? 1u : 0u, plan.raster() ? 1u : 0u, plan.rgb ? 1u : 0u}),
                  {{"VolumeBlock", buffer("volume")},
                   {"WarpTable", buffer("warp")},
                   {"Occupancy", buffer("occupancy")},
                   {"Extinction", buffer("extinction")},
                   {"Overflow", buffer("overflow")},
                   {"ExtinctionRgb", buffer("extinction_rgb")},
                   {"OverflowRgb", buffer("overflow_rgb")},
                   {"integral", &picture.resources.image("integral")},
                   {"integral_rg", &picture.resources.image("integral_rg")},
                   {"integral_b", &picture.resources.image("integral_b")},
                   {"extinction_layers", &picture.resources.image("extinction_layers")},
                   {"extinction_layers_rgb", &picture.resources.image("extinction_layers_rgb")},
                   {"ZeroSlice", buffer("zero_slice")},
                   {"RgbStart", buffer("rgb_start")}},
                  0u, {plan.volume.tiles.x, plan.volume.tiles.y, 1});
  });
}

}  // namespace plume::avboit
