#include "sandbox/effects/view_volume.h"

namespace plume {

ViewVolume view_volume(const shared::ViewData& view, float widen) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const glm::vec2 tan = view.tan_half_fov * widen;
  const glm::vec3 forward = view.forward, across = view.right * tan.x, upwards = view.up * tan.y;
  const auto through_eye = [&](glm::vec3 normal) {
    return ViewVolume::Plane{normal, glm::dot(normal, view.camera)};
  };
  ViewVolume volume{
      .planes = {ViewVolume::Plane{forward, glm::dot(forward, view.camera) + view.near_m},
                 through_eye(forward * tan.x + view.right), through_eye(forward * tan.x - view.right),
                 through_eye(forward * tan.y + view.up), through_eye(forward * tan.y - view.up)},
      .hull = {.min = view.camera, .max = view.camera}};
  for (const glm::vec3 edge : {forward - across - upwards, forward + across - upwards,
                               forward - across + upwards, forward + across + upwards})
    for (int c = 0; c < 3; ++c) {
      if (edge[c] < 0) volume.hull.min[c] = -kInfinity;
      if (edge[c] > 0) volume.hull.max[c] = kInfinity;
    }
  return volume;
}

bool may_touch(const ViewVolume& volume, const Bounds& bounds) {
  if (bounds.empty()) return false;
  for (int c = 0; c < 3; ++c)
    if (bounds.min[c] > volume.hull.max[c] || bounds.max[c] < volume.hull.min[c]) return false;
  for (const auto& [normal, distance] : volume.planes) {
    const glm::vec3 farthest = glm::mix(bounds.min, bounds.max, glm::greaterThan(normal, glm::vec3(0.0f)));
    // Above what rounding of the sum can hide.
    const float slack = 4e-7f * (glm::dot(glm::abs(normal), glm::abs(farthest)) + std::abs(distance));
    if (glm::dot(normal, farthest) < distance - slack) return false;
  }
  return true;
}

}  // namespace plume
