#include "renderer/methods/avboit/plan.h"
#include "renderer/methods/parts/farthest_depth.h"
#include "shaders/methods/avboit/overlap.h"

namespace plume::avboit {
namespace {

uint32_t overflow_handling(Splat splat) {
  switch (splat) {
    case Splat::kPacked8Exchange:
      return 1;
    case Splat::kPacked8Overflow:
    case Splat::kPacked16Overflow:
      return 2;
    default:
      return 0;
  }
}

}  // namespace

void add_splat_needs(Needs& needs, const Plan& plan) {
  const uint64_t rays = plan.rays();
  farthest_depth::add_needs(needs, plan.volume.divisor);
  needs.buffers.push_back({.name = "extinction",
                           .bytes = rays * plan.volume.slices * plan.settings.lane_bits() / 8,
                           .clear = {}});
  needs.buffers.push_back({.name = "overflow", .bytes = rays * 4, .clear = shared::kNoOverflow});
  needs.buffers.push_back({.name = "overlaps",
                           .bytes = (plan.watches_overlap() ? rays : 1) * sizeof(shared::Overlap),
                           .clear = 0});
  const auto add_layers = [&](const char* name, vk::Format format, bool wanted) {
    needs.images.push_back({.name = name,
                            .format = format,
                            .usage = kTargetUsage,
                            .divisor = wanted ? plan.volume.divisor : kNowhere,
                            .layers = wanted ? plan.volume.slices : 1});
  };
  add_layers("extinction_layers", vk::Format::eR8Unorm, plan.raster());
  add_layers("extinction_layers_rgb", vk::Format::eA2B10G10R10UnormPack32, plan.rgb_raster());
  // A descriptor needs something to point at where there are no RGB sources.
  needs.buffers.push_back({.name = "extinction_rgb",
                           .bytes = std::max<uint64_t>(rays * plan.volume.slices * plan.rgb_words() * 4, 4),
                           .clear = {}});
  needs.buffers.push_back(
      {.name = "overflow_rgb", .bytes = plan.rgb_words() == 1 ? rays * 16 : 4, .clear = shared::kNoOverflow});
}

void record_splat(const Picture& picture, const Plan& plan) {
  const auto buffer = [&](const char* name) { return &picture.resources.buffer(name); };
  const shared::Volume& v = plan.volume;
  const gpu::Image& farthest = picture.resources.image("farthest");
  const gpu::Binding volume{"VolumeBlock", buffer("volume")}, warp{"WarpTable", buffer("warp")};

  farthest_depth::record(picture, v.divisor);

  const gpu::Constants common{plan.settings.linear_splat ? 1u : 0u, plan.settings.samples == 0 ? 1u : 4u,
                              plan.settings.dither ? 1u : 0u};
  const auto draw = [&](gpu::Pass& pass, const char* fragment, uint32_t into,
                        std::vector<uint32_t> own_constants, gpu::Bindings own_bindings) {
    gpu::Constants constants = common;
    constants.insert(constants.end(), own_constants.begin(), own_constants.end());
    own_bindings.insert(own_bindings.end(), {volume, warp});
    picture.transparents.draw(pass, {.fragment = fragment,
                                     .targets = {},
                                     .opaque_depth = &farthest,
                                     .area = {v.cells.x, v.cells.y},
                                     .constants = std::move(constants),
                                     .bindings = std::move(own_bindings),
                                     .order = buffer("source_order"),
                                     .indirect = buffer("source_draws"),
                                     .indirect_index = into,
                                     .covered = glm::vec2(plan.size) / glm::vec2(v.cells * v.divisor)});
  };
  const auto draw_layers = [&](gpu::Pass& pass, const char* target, uint32_t into) {
    const gpu::Image& layers = picture.resources.image(target);
    pass.clear(layers, {1, 1, 1, 1});
    pass.barrier();
    for (uint32_t beyond = 0; beyond < (plan.settings.linear_splat ? 2u : 1u); ++beyond) {
      gpu::Constants constants = common;
      constants.insert(constants.end(), {into == shared::kIntoRgb ? 1u : 0u, beyond});
      picture.transparents.draw(pass,
                                {.fragment = "methods/avboit/splat_layer.frag",
                                 .targets = {{.image = &layers, .blend = gpu::Blend::kMultiply, .clear = {}}},
                                 .opaque_depth = &farthest,
                                 .area = {v.cells.x, v.cells.y},
                                 .vertex = "methods/avboit/splat_layer.vert",
                                 .constants = std::move(constants),
                                 .bindings = {volume, warp},
                                 .order = buffer("source_order"),
                                 .indirect = buffer("source_draws"),
                                 .indirect_index = into,
                                 .covered = glm::vec2(plan.size) / glm::vec2(v.cells * v.divisor)});
    }
  };
  picture.frame.pass("splat", [&](gpu::Pass& pass) {
    if (plan.raster())
      draw_layers(pass, "extinction_layers", shared::kIntoScalar);
    else
      draw(pass, "methods/avboit/splat.frag", shared::kIntoScalar,
           {plan.settings.lane_bits(), overflow_handling(plan.settings.splat),
            plan.watches_overlap() ? 1u : 0u},
           {{"Extinction", buffer("extinction")},
            {"Overflow", buffer("overflow")},
            {"Overlaps", buffer("overlaps")}});
    if (plan.rgb_raster())
      draw_layers(pass, "extinction_layers_rgb", shared::kIntoRgb);
    else if (plan.rgb)
      draw(pass, "methods/avboit/splat_rgb.frag", shared::kIntoRgb, {plan.rgb_words() == 1 ? 1u : 0u},
           {{"ExtinctionRgb", buffer("extinction_rgb")}, {"OverflowRgb", buffer("overflow_rgb")}});
  });
}

}  // namespace plume::avboit
