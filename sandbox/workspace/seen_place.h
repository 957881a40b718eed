// What one sees at a place of the picture, to turn the camera to: smoke or glass where most of what is seen
// there is theirs, otherwise what stands behind it.
#ifndef PLUME_WORKSPACE_SEEN_PLACE_H
#define PLUME_WORKSPACE_SEEN_PLACE_H

#include "sandbox/measure/pixel_probe.h"
#include "sandbox/workspace/workspace.h"

namespace plume {

/// The depth up to which half of what is seen at a pixel comes. A fragment's share is the part of the light
/// it keeps from passing, or what it glows if that is more; the opaque surface has what is left. `fragment`:
/// whose depth it is, nothing for the surface. Nothing at all: the sky.
struct SeenDepth {
  float depth_m;
  std::optional<size_t> fragment;
};
std::optional<SeenDepth> seen_depth(const PixelProbe& probe);

struct SeenPlace {
  glm::vec3 position;
  std::string instance;  ///< of the scene; "": no particle's
};
/// In the picture that was drawn last, at shares of its width and height. Waits for the device.
std::optional<SeenPlace> seen_at(Workspace& workspace, glm::vec2 place);

}  // namespace plume
#endif
