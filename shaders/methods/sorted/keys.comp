// Sort keys of cards: view depth of the centre, as an unsigned integer of the same order; the value is the card's index.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/card.h"
#include "shared/view.h"

layout(local_size_x = 256) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 2) writeonly buffer Pairs { uvec2 pairs[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  const uint bits = floatBitsToUint(dot(cards[i].center - view.camera, view.forward));
  pairs[i] = uvec2((bits & 0x80000000u) != 0u ? ~bits : bits | 0x80000000u, i);
}
