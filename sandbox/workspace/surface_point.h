// The point of the scene that is seen at a pixel: on its opaque surface.
#ifndef PLUME_WORKSPACE_SURFACE_POINT_H
#define PLUME_WORKSPACE_SURFACE_POINT_H

#include <optional>

#include "renderer/frame.h"
#include "shaders/shared/view.h"

namespace plume {

/// At `view_depth` metres along the line of sight through a place of the picture: shares of its width and
/// height, from the upper left.
glm::vec3 point_at(const shared::ViewData& view, glm::vec2 place, float view_depth);

/// As `targets` were drawn last by `view`. Nothing: the sky. Waits for the device.
std::optional<glm::vec3> surface_at(gpu::Device& device, const Targets& targets, const shared::ViewData& view,
                                    glm::vec2 place);

}  // namespace plume
#endif
