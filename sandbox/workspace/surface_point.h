// The point of the scene that is seen at a pixel: on its opaque surface.
#ifndef PLUME_WORKSPACE_SURFACE_POINT_H
#define PLUME_WORKSPACE_SURFACE_POINT_H

#include <optional>
#include <vector>

#include "renderer/frame.h"
#include "shaders/shared/view.h"

namespace plume {

/// At `view_depth` metres along the line of sight through a place of the picture: shares of its width and
/// height, from the upper left.
glm::vec3 point_at(const shared::ViewData& view, glm::vec2 place, float view_depth);
/// Where in the picture a point is seen; nothing: it is not in front of the camera.
std::optional<glm::vec2> place_of(const shared::ViewData& view, glm::vec3 point);
/// Where the line of sight through a place meets the plane through `on` across `normal`; nothing: it does
/// not, or beyond what the camera sees.
std::optional<glm::vec3> on_plane(const shared::ViewData& view, glm::vec2 place, glm::vec3 on,
                                  glm::vec3 normal);

struct SurfacePoint {
  glm::vec3 position, normal;
};

/// Of a picture that stays: its depths are read from the device once.
class SurfaceDepths {
 public:
  /// As `targets` were drawn last by `view`. Waits for the device.
  SurfaceDepths(gpu::Device& device, const Targets& targets, const shared::ViewData& view);
  /// Nothing: the sky. The normal is of the pixels around, and up where these tell none.
  std::optional<SurfacePoint> at(glm::vec2 place) const;

 private:
  std::optional<glm::vec3> point(glm::ivec2 pixel) const;

  shared::ViewData view_;
  glm::ivec2 size_;
  std::vector<float> depths_;  // near_m over view depth, 0 the sky
};

}  // namespace plume
#endif
