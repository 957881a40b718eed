// Where an emitter can change a picture: where its particles are drawn, where their shadow falls, and where
// their light reaches. Out of these bounds it need not be simulated.
#ifndef PLUME_EFFECTS_INFLUENCE_H
#define PLUME_EFFECTS_INFLUENCE_H

#include "sandbox/effects/bounds.h"

namespace plume {

/// Limits: shadows are followed over this way, fires light what is this near; what they do beyond is lost
/// while they are out of view themselves.
constexpr float kShadowReach_m = 30.0f;
constexpr float kFireReach_m = 15.0f;

/// `drawn` are the bounds of its cards; `sun_direction` is the unit vector towards the sun.
Bounds influence(const Look& look, const Bounds& drawn, glm::vec3 sun_direction);

}  // namespace plume
#endif
