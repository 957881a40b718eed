// View depth of a card's centre as an unsigned integer of the same order.
#ifndef PLUME_METHODS_SORTED_DEPTH_KEY_GLSL
#define PLUME_METHODS_SORTED_DEPTH_KEY_GLSL
#include "shared/view.h"
#include "surface/seen_cards.glsl"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };

uint depth_key(uint card) {
  const uint bits = floatBitsToUint(dot(cards[card].center - view.camera, view.forward));
  return (bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u;
}

#endif
