// Where an emitter's particles can ever be drawn, from the description alone: no state is read back, so what
// is out of view need not be simulated to know that it is.
//
// The scheme of shaders/effects/step.glsl, v' = u + (v + a dt - u) q with q = 1 / (1 + drag dt) and
// x' = x + v' dt, is linear with weights that are not negative. So the largest coordinate at an age follows
// from the largest at birth, of the velocity and of the acceleration, axis by axis and tick by tick: interval
// arithmetic here loses nothing. Gravity, buoyancy and wind are followed exactly; what depends on the place
// (curl, vortex, attractors, fields) counts with its largest size in every direction at once. Where an orbit
// or a collision mixes axes, only the lengths of velocity and way are followed. What is born of parents
// starts anywhere that these can be. Every step is widened by what rounding to floats can add to it.
//
// Limits: noise hardly ever comes near its largest size and never pushes one way for long, so emitters with
// strong curl are seen in a small part of their bounds. A kill volume with `outside` bounds them too, and
// well. The camera offset is left out: it does not change where on the picture a card is.
#ifndef PLUME_EFFECTS_BOUNDS_H
#define PLUME_EFFECTS_BOUNDS_H

#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/effects/path.h"
#include "sandbox/scene/scene.h"

namespace plume {

/// A box in the world, m; empty as long as nothing was added.
struct Bounds {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};

  bool empty() const { return !(min.x <= max.x); }
  bool contains(glm::vec3 point) const;
  void add(const Bounds& other);
  double volume() const;
};

/// Where and in what wind an effect is called.
struct Placement {
  glm::vec3 position{0.0f};
  float yaw_deg = 0.0f;
  const Path* path = nullptr;
  glm::vec3 wind{0.0f};                        ///< of the scene, m/s
  const std::vector<Solid>* solids = nullptr;  ///< that particles collide with
};

/// Of every card at every tick, emitter by emitter. Takes some 0.1 us for each tick of a life.
std::vector<Bounds> emitter_bounds(const Effect& effect, const Placement& placement);
/// All of them together.
Bounds effect_bounds(const Effect& effect, const Placement& placement);

}  // namespace plume
#endif
