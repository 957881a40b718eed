// The vertex shader where particles and hard-edged cards are drawn at different resolutions: of each kind by itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"
#include "effects/puff.h"

layout(constant_id = 3) const uint kSoft = 0u;   // 1: puffs and soft dots; 0: discs and solid squares

void main() {
  const uint id = card_id();
  const uint layer = cards[id].layers & ((1u << kLayerBits) - 1u);
  const bool soft = layer != kDiscLayer && layer != kSolidLayer;
  place_card(cards[id], id, shows(cards[id]) && soft == (kSoft != 0u));
}
