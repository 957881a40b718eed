#include "renderer/methods/parts/farthest_depth.h"

namespace plume::farthest_depth {

void add_needs(Needs& needs, uint32_t divisor) {
  needs.images.push_back({.name = "farthest",
                          .format = vk::Format::eR32Sfloat,
                          .usage = vk::ImageUsageFlagBits::eStorage | vk::ImageUsageFlagBits::eSampled,
                          .divisor = divisor});
}

void record(const Picture& picture, uint32_t divisor) {
  const glm::uvec2 cells = (picture.size + divisor - 1u) / divisor;
  picture.frame.pass("farthest", [&](gpu::Pass& pass) {
    pass.dispatch(
        pass.pipelines().compute("surface/farthest.comp"),
        {{"opaque_depth", &picture.opaque_depth}, {"farthest", &picture.resources.image("farthest")}},
        glm::uvec3(cells, divisor), {gpu::groups(cells.x, 8), gpu::groups(cells.y, 8), 1});
  });
}

}  // namespace plume::farthest_depth
