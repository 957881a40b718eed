// AVBOIT, sources: where the extinction of each card goes, in the order of submission, for a stable sort into one draw each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/bounds.glsl"
#include "methods/avboit/card_class.h"
#include "methods/avboit/sharp.glsl"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 11) writeonly buffer Pairs { uvec2 pairs[]; };

uint class_of(uint id) {
  const Card card = cards[id];
  if (card.optical_depth <= 0.0 || !bounds_of(card, view).seen) return kClassUnseen;
  if (is_sharp(card, view, volume)) return kIntoLayers;
  return id >= volume.rgb_first ? kIntoRgb : kIntoScalar;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) pairs[i] = uvec2(class_of(order[i]), order[i]);
}
