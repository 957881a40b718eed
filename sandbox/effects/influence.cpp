#include "sandbox/effects/influence.h"

#include "sandbox/effects/lighting.h"

namespace plume {

Bounds influence(const Look& look, const Bounds& drawn, glm::vec3 sun_direction) {
  Bounds bounds = drawn;
  if (drawn.empty()) return bounds;
  if (casts_shadow(look)) {
    const glm::vec3 away = -kShadowReach_m * sun_direction;
    bounds.add({.min = drawn.min + away, .max = drawn.max + away});
  }
  if (glows(look)) bounds.add({.min = drawn.min - kFireReach_m, .max = drawn.max + kFireReach_m});
  return bounds;
}

}  // namespace plume
