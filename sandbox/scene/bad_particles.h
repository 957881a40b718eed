// Particles that a picture leaves out because nothing can be drawn with their numbers (see
// shaders/shared/bad_number.h): how many they are, and whose.
#ifndef PLUME_SCENE_BAD_PARTICLES_H
#define PLUME_SCENE_BAD_PARTICLES_H

#include <nlohmann/json.hpp>

#include "sandbox/scene/card_owner.h"

namespace plume {

struct BadParticles {
  uint32_t count = 0;
  std::optional<CardOwner> first;  ///< nothing: there is none
  std::string moved_by;            ///< what its emitter asks for: "gravity, curl noise"
};

/// Of the last frame that was drawn of the stage, at the tick that it stands at. Waits for nothing.
BadParticles bad_particles(const Stage& stage);

/// "3 particles are not finite, and left out; first: smoke (left bank) / core #17". Empty: there is none.
std::string to_text(const BadParticles& bad);
/// What to do about them, in a sentence or two without the last full stop. Empty: there is none.
std::string remedy(const BadParticles& bad);
/// {"count": 3, "first": {"effect": …, "instance": …, "emitter": …, "birth": 17}}; first: null.
nlohmann::json to_json(const BadParticles& bad);

}  // namespace plume
#endif
