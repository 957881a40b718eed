// A pane of the scene as a card.
#ifndef PLUME_SCENE_PANE_CARD_H
#define PLUME_SCENE_PANE_CARD_H

#include "sandbox/scene/scene.h"
#include "shaders/shared/card.h"

namespace plume {

shared::Card pane_card(const Pane& pane);

}  // namespace plume
#endif
