// Seen cards, sources: which source each card belongs to, or none, in the order of submission, for a stable sort.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/draw_command.h"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) writeonly buffer Pairs { uvec2 pairs[]; };
layout(push_constant) uniform Push { uint haze_first, rgb_first; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint id = order[i];
  const bool seen = shows(cards[id]) || bends(cards[id]);
  pairs[i] = uvec2(!seen ? kUnseenSource : id >= rgb_first ? 2u : id >= haze_first ? 1u : 0u, id);
}
