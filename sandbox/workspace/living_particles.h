// Where the living particles of an instance are, and what a camera that looks at it should hold in view.
#ifndef PLUME_WORKSPACE_LIVING_PARTICLES_H
#define PLUME_WORKSPACE_LIVING_PARTICLES_H

#include <vector>

#include "sandbox/scene/stage.h"

namespace plume {

/// Emitter by emitter, at the tick that the stage stands at; nothing where it sleeps, or its particles have
/// no state. Empty when the instance is not called. Waits for the device.
std::vector<std::vector<glm::vec3>> living_positions(const Stage& stage, size_t instance);

struct Ball {
  glm::vec3 centre{0.0f};
  float radius_m = 1.0f;
};
/// Round most of what lives of an instance: on each axis a twentieth is left out at either end, so that a few
/// stray sparks do not count. Of emitters without states, the bounds; where nothing lives, a metre round
/// where the instance stands. Throws std::out_of_range.
Ball ball_round(const Stage& stage, size_t instance);

}  // namespace plume
#endif
