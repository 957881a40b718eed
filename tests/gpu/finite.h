// Whether what the simulation made is made of numbers.
#ifndef PLUME_TESTS_FINITE_H
#define PLUME_TESTS_FINITE_H

#include <cmath>
#include <glm/gtc/packing.hpp>

#include "shaders/shared/card.h"
#include "shaders/shared/particle.h"

namespace plume {

inline bool is_finite(glm::vec3 v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
inline bool is_finite(glm::uvec2 halves) {
  const glm::vec2 low = glm::unpackHalf2x16(halves.x), high = glm::unpackHalf2x16(halves.y);
  return is_finite(glm::vec3(low, high.x)) && std::isfinite(high.y);
}
inline bool is_finite(const shared::Particle& p) {
  return is_finite(p.position) && is_finite(p.velocity);
}
inline bool is_finite(const shared::Card& c) {
  return is_finite(c.center) && is_finite(c.axis_u) && is_finite(c.axis_v) &&
         is_finite(glm::vec3(c.optical_depth, c.inv_feather, 0)) && is_finite(c.sunlit) &&
         is_finite(c.ambient) && is_finite(c.emission) && is_finite(c.transmission) && is_finite(c.light) &&
         is_finite(c.motion);
}

}  // namespace plume
#endif
