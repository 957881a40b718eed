// A standing person made of spheres and capsules: something of known size to hide in smoke.
#ifndef PLUME_SCENE_FIGURE_H
#define PLUME_SCENE_FIGURE_H

#include <glm/glm.hpp>
#include <vector>

#include "sandbox/scene/scene.h"

namespace plume {

/// The solids of a person `height_m` tall who stands with the feet at `feet` and looks along +z turned by
/// `yaw_deg` about +y.
std::vector<Solid> standing_figure(const glm::vec3& feet, float yaw_deg, float height_m,
                                   const glm::vec3& color, Material material);

}  // namespace plume
#endif
