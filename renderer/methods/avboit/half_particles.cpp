#include "renderer/methods/avboit/plan.h"

namespace plume::avboit {

void add_half_particles_needs(Needs& needs, const Plan& plan) {
  const uint32_t half = plan.settings.half_particles ? 2 : kNowhere;
  needs.images.push_back({.name = "half_visible",
                          .format = vk::Format::eD32Sfloat,
                          .usage = vk::ImageUsageFlagBits::eDepthStencilAttachment,
                          .divisor = half});
  needs.images.push_back({.name = "half_opaque",
                          .format = vk::Format::eR32Sfloat,
                          .usage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled,
                          .divisor = half});
}

void record_half_depth(const Picture& picture, const Plan& plan) {
  if (!plan.settings.half_particles) return;
  const gpu::Image& visible = picture.resources.image("half_visible");
  const gpu::Image& opaque = picture.resources.image("half_opaque");
  const glm::uvec2 half = (plan.size + 1u) / 2u;
  picture.frame.pass("half_depth", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/avboit/half_depth.comp"),
                  {{"opaque_depth", &picture.opaque_depth}, {"half_opaque", &opaque}}, half,
                  {gpu::groups(half.x, 8), gpu::groups(half.y, 8), 1});
    pass.draw({.vertex = "post/fullscreen.vert",
               .fragment = "surface/low_depth.frag",
               .targets = {},
               .depth = &visible,
               .depth_use = gpu::DepthUse::kTestAndWrite,
               .clear_depth = true,
               .area = {half.x, half.y},
               .constants = {2},
               .bindings = {{"full_depth", &visible_depth(picture, plan)}}},
              0u);
  });
}

}  // namespace plume::avboit
