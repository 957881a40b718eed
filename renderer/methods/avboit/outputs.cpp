#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void record_outputs(const Picture& picture, const Plan& plan) {
  const auto draw = [&](const char* pass_name, const gpu::Image& output, Transparents::Style style) {
    style.targets = {
        {.image = &output, .blend = gpu::Blend::kAdd, .clear = std::array{0.0f, 0.0f, 0.0f, 0.0f}}};
    style.depth_test = &visible_depth(picture, plan);
    style.opaque_depth = &picture.opaque_depth;
    style.area = picture.area();
    style.constants = {uint32_t(plan.settings.sampling),
                       plan.settings.linear_splat ? 1u : 0u,
                       plan.rgb ? 1u : 0u,
                       0,
                       0,
                       0,
                       0,
                       0,
                       plan.settings.lane_bits()};
    style.bindings = transmittance_bindings(picture);
    picture.frame.pass(pass_name, [&](gpu::Pass& pass) { picture.transparents.draw(pass, style); });
  };
  if (picture.distortion)
    draw("distortion", *picture.distortion,
         {.fragment = "methods/avboit/haze.frag",
          .targets = {},
          .vertex = "surface/haze.vert",
          .source = Source::kHaze,
          .constants = {},
          .bindings = {}});
  if (picture.surface)
    draw("surface", *picture.surface,
         {.fragment = "methods/avboit/surface.frag", .targets = {}, .constants = {}, .bindings = {}});
}

}  // namespace plume::avboit
