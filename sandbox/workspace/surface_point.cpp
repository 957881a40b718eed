#include "sandbox/workspace/surface_point.h"

namespace plume {

glm::vec3 point_at(const shared::ViewData& view, glm::vec2 place, float view_depth) {
  const glm::vec2 across = (place * 2.0f - 1.0f) * view.tan_half_fov;
  return view.camera + (view.forward + view.right * across.x - view.up * across.y) * view_depth;
}

std::optional<glm::vec3> surface_at(gpu::Device& device, const Targets& targets, const shared::ViewData& view,
                                    glm::vec2 place) {
  const glm::vec2 size(targets.size);
  const glm::uvec2 pixel(glm::clamp(place * size, glm::vec2(0), size - 1.0f));
  const std::vector<float> depths = gpu::read<float>(device, targets.opaque_depth);
  const float depth = depths[size_t(pixel.y) * targets.size.x + pixel.x];
  if (depth <= 0) return {};
  return point_at(view, (glm::vec2(pixel) + 0.5f) / size, view.near_m / depth);
}

}  // namespace plume
