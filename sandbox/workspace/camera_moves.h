// How a camera is moved by hand: round its target, with its target, or through the scene.
#ifndef PLUME_WORKSPACE_CAMERA_MOVES_H
#define PLUME_WORKSPACE_CAMERA_MOVES_H

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

/// What a camera sees to its right and upwards, and where it looks.
struct CameraAxes {
  glm::vec3 right, up, forward;
};
inline CameraAxes axes_of(const CameraKey& camera) {
  const glm::vec3 forward = glm::normalize(camera.target - camera.position);
  const glm::vec3 right = glm::normalize(glm::cross(forward, glm::vec3(0, 1, 0)));
  return {right, glm::cross(right, forward), forward};
}

/// Slides the picture under the pointer: `share` is of the picture's height, so that what is as far as the
/// target stays under it.
inline CameraKey pan(CameraKey camera, glm::vec2 share) {
  const auto [right, up, forward] = axes_of(camera);
  const float height =
      2 * glm::length(camera.target - camera.position) * std::tan(glm::radians(camera.vertical_fov_deg) / 2);
  const glm::vec3 by = (up * share.y - right * share.x) * height;
  camera.position += by;
  camera.target += by;
  return camera;
}

/// Turns the head: by `degrees.x` to the right, by `degrees.y` up. Stops short of straight up and down.
inline CameraKey look(CameraKey camera, glm::vec2 degrees) {
  const glm::vec3 arm = camera.target - camera.position;
  CameraKey turned = camera;
  turned.position = camera.position + arm;  // as seen from the target, the eye turns the other way
  turned.target = camera.position;
  turned = orbit(turned, degrees);
  camera.target = turned.position;
  return camera;
}

/// Flies by `metres` to the right, up and ahead.
inline CameraKey fly(CameraKey camera, glm::vec3 metres) {
  const auto [right, up, forward] = axes_of(camera);
  const glm::vec3 by = right * metres.x + glm::vec3(0, 1, 0) * metres.y + forward * metres.z;
  camera.position += by;
  camera.target += by;
  return camera;
}

/// Looks at a place from where it is.
inline CameraKey focus(CameraKey camera, glm::vec3 place) {
  if (glm::length(place - camera.position) >= kNearestOrbitM) camera.target = place;
  return camera;
}

/// Comes as near as a ball fills most of the picture's smaller side, without turning, and turns about it from
/// then on. `aspect` is the picture's width over its height.
inline CameraKey frame(CameraKey camera, glm::vec3 centre, float radius_m, float aspect) {
  constexpr float kAir = 1.25f;
  const float half_height = std::tan(glm::radians(camera.vertical_fov_deg) / 2);
  const float half_side = std::atan(half_height * std::min(aspect, 1.0f));
  const float wanted = std::clamp(kAir * radius_m / std::sin(half_side), kNearestOrbitM, kFarthestOrbitM);
  const glm::vec3 arm = camera.position - camera.target;
  camera.position = centre + arm * (wanted / glm::length(arm));
  camera.target = centre;
  return camera;
}

}  // namespace plume
#endif
