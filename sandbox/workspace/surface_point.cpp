#include "sandbox/workspace/surface_point.h"

namespace plume {

glm::vec3 point_at(const shared::ViewData& view, glm::vec2 place, float view_depth) {
  const glm::vec2 across = (place * 2.0f - 1.0f) * view.tan_half_fov;
  return view.camera + (view.forward + view.right * across.x - view.up * across.y) * view_depth;
}

std::optional<glm::vec2> place_of(const shared::ViewData& view, glm::vec3 point) {
  const glm::vec3 arm = point - view.camera;
  const float depth = glm::dot(arm, view.forward);
  if (depth < view.near_m) return {};
  const glm::vec2 across = glm::vec2(glm::dot(arm, view.right), -glm::dot(arm, view.up)) / depth;
  return across / view.tan_half_fov * 0.5f + 0.5f;
}

std::optional<glm::vec3> on_plane(const shared::ViewData& view, glm::vec2 place, glm::vec3 on,
                                  glm::vec3 normal) {
  const glm::vec3 ray = point_at(view, place, 1.0f) - view.camera;
  const float towards = glm::dot(ray, normal), away = glm::dot(on - view.camera, normal);
  if (away / towards < view.near_m || !(away / towards < view.far_m)) return {};  // also where towards is 0
  return view.camera + ray * (away / towards);
}

SurfaceDepths::SurfaceDepths(gpu::Device& device, const Targets& targets, const shared::ViewData& view)
    : view_(view), size_(targets.size), depths_(gpu::read<float>(device, targets.opaque_depth)) {}

std::optional<glm::vec3> SurfaceDepths::point(glm::ivec2 pixel) const {
  if (glm::any(glm::lessThan(pixel, glm::ivec2(0))) || glm::any(glm::greaterThanEqual(pixel, size_)))
    return {};
  const float depth = depths_[size_t(pixel.y) * size_t(size_.x) + size_t(pixel.x)];
  if (depth <= 0) return {};
  return point_at(view_, (glm::vec2(pixel) + 0.5f) / glm::vec2(size_), view_.near_m / depth);
}

std::optional<SurfacePoint> SurfaceDepths::at(glm::vec2 place) const {
  const glm::vec2 size(size_);
  const glm::ivec2 pixel(glm::clamp(place * size, glm::vec2(0), size - 1.0f));
  const auto here = point(pixel);
  if (!here) return {};
  const auto left = point(pixel - glm::ivec2(1, 0)), right = point(pixel + glm::ivec2(1, 0));
  const auto above = point(pixel - glm::ivec2(0, 1)), below = point(pixel + glm::ivec2(0, 1));
  glm::vec3 normal{0, 1, 0};
  if ((left || right) && (above || below)) {
    // The shorter step of each two stays on this side of an edge.
    const auto shorter = [&](const auto& a, const auto& b) {
      const glm::vec3 back = a ? *here - *a : glm::vec3(1e9f), on = b ? *b - *here : glm::vec3(1e9f);
      return glm::dot(back, back) < glm::dot(on, on) ? back : on;
    };
    const glm::vec3 across = glm::cross(shorter(above, below), shorter(left, right));
    if (glm::dot(across, across) > 0) normal = glm::normalize(across);
  }
  return SurfacePoint{*here, normal};
}

}  // namespace plume
