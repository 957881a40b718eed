// A camera that circles its target: what dragging and the wheel do.
#ifndef PLUME_WINDOW_ORBIT_H
#define PLUME_WINDOW_ORBIT_H

#include <algorithm>
#include <cmath>

#include "sandbox/scene/scene.h"

namespace plume {

/// Where the wheel stops, in metres from the target.
constexpr float kNearestOrbitM = 0.2f, kFarthestOrbitM = 1000.0f;

/// Turns the scene as if it were pushed: by `degrees.x` to the right about +y, by `degrees.y` down. Stops
/// short of looking straight up or down, where up would lose its meaning.
inline CameraKey orbit(CameraKey camera, glm::vec2 degrees) {
  constexpr float kSteepest = glm::radians(89.0f);
  const glm::vec3 arm = camera.position - camera.target;
  const float length = glm::length(arm);
  const float yaw = std::atan2(arm.x, arm.z) - glm::radians(degrees.x);
  const float pitch = std::clamp(std::asin(std::clamp(arm.y / length, -1.0f, 1.0f)) + glm::radians(degrees.y),
                                 -kSteepest, kSteepest);
  camera.position = camera.target + length * glm::vec3(std::cos(pitch) * std::sin(yaw), std::sin(pitch),
                                                       std::cos(pitch) * std::cos(yaw));
  return camera;
}

/// A tenth nearer for every step of the wheel.
inline CameraKey zoom(CameraKey camera, float steps) {
  const glm::vec3 arm = camera.position - camera.target;
  const float length = glm::length(arm);
  const float wanted = std::clamp(length * std::pow(0.9f, steps), kNearestOrbitM, kFarthestOrbitM);
  camera.position = camera.target + arm * (wanted / length);
  return camera;
}

}  // namespace plume
#endif
