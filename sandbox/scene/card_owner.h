// Whose a card is: a pane of the scene, or a particle of an effect that it calls.
#ifndef PLUME_SCENE_CARD_OWNER_H
#define PLUME_SCENE_CARD_OWNER_H

#include "sandbox/scene/stage.h"

namespace plume {

struct CardOwner {
  std::optional<uint32_t> pane;  ///< in the order of the scene, from 0; then nothing else holds
  std::string effect, instance, emitter;
  uint32_t birth = 0;  ///< of the particle, among the births of its emitter
  uint32_t part = 0;   ///< of a particle of several cards: which of them
};
/// "pane 3", "smoke_grenade (left bank) / core #1042".
std::string to_text(const CardOwner& owner);

/// At the tick that the stage stands at. After the last card come the pieces of opaque debris, as
/// shared::BadCards counts them. Throws std::out_of_range for what it does not have.
CardOwner owner_of(const Stage& stage, uint32_t card);

}  // namespace plume
#endif
