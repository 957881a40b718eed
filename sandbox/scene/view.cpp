#include "sandbox/scene/view.h"

#include <cmath>

namespace plume {
namespace {

struct Frustum {
  glm::vec3 forward, right, up;
  glm::vec2 tan_half_fov;
  glm::mat4 view_projection;
};

Frustum frustum_of(const CameraKey& camera, glm::uvec2 size, float near_m) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const glm::vec3 straight_up = std::abs(forward.y) < 0.999f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  const glm::vec3 right = glm::normalize(glm::cross(forward, straight_up));
  const glm::vec3 up = glm::cross(right, forward);
  const float tan_y = std::tan(glm::radians(camera.vertical_fov_deg) * 0.5f);
  const float tan_x = tan_y * float(size.x) / float(size.y);

  // Rows of clip = M * (world, 1): x and y over the view frustum (Vulkan's y points down), z = near, w = view
  // depth.
  const auto row = [&](glm::vec3 axis) { return glm::vec4(axis, -glm::dot(axis, camera.position)); };
  const glm::vec4 rows[4] = {row(right) / tan_x, row(up) / -tan_y, {0, 0, 0, near_m}, row(forward)};
  Frustum frustum{forward, right, up, {tan_x, tan_y}, {}};
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) frustum.view_projection[c][r] = rows[r][c];
  return frustum;
}

}  // namespace

shared::ViewData make_view(const Scene& scene, const CameraKey& camera, glm::uvec2 size, uint32_t tick,
                           const std::optional<CameraKey>& previous) {
  const auto [forward, right, up, tan_half_fov, view_projection] = frustum_of(camera, size, scene.near_m);
  return {.view_projection = view_projection,
          .camera = camera.position,
          .near_m = scene.near_m,
          .right = right,
          .far_m = scene.far_m,
          .up = up,
          .exposure = scene.exposure,
          .forward = forward,
          .tick = tick,
          .tan_half_fov = tan_half_fov,
          .size = size,
          .sun_direction = scene.light.sun_direction,
          .sky = scene.light.sky,
          .sun_color = scene.light.sun_color,
          .tonemap = uint32_t(scene.tonemap),
          .zenith = scene.light.zenith,
          .solid_count = uint32_t(scene.solids.size()),
          .horizon = scene.light.horizon,
          .padding = 0,
          .previous_view_projection =
              previous ? frustum_of(*previous, size, scene.near_m).view_projection : view_projection};
}

}  // namespace plume
