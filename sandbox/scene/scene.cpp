#include "sandbox/scene/scene.h"

#include <algorithm>
#include <stdexcept>

namespace plume {

CameraKey camera_at(const std::vector<CameraKey>& keys, uint32_t tick) {
  if (keys.empty()) throw std::invalid_argument("a camera needs at least one key");
  const auto after = std::ranges::upper_bound(keys, tick, {}, &CameraKey::tick);
  CameraKey camera = after == keys.begin() ? keys.front() : *std::prev(after);
  if (after != keys.begin() && after != keys.end()) {
    const float f = static_cast<float>(tick - camera.tick) / static_cast<float>(after->tick - camera.tick);
    camera.position = glm::mix(camera.position, after->position, f);
    camera.target = glm::mix(camera.target, after->target, f);
    camera.vertical_fov_deg = glm::mix(camera.vertical_fov_deg, after->vertical_fov_deg, f);
  }
  camera.tick = tick;
  return camera;
}

}  // namespace plume
