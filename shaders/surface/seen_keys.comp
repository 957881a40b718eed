// Seen cards, sources: which source each card belongs to, or none, in the order of submission, for a stable sort. Cards with a bad number
// belong to none, and are counted.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/bad_number.h"
#include "shared/draw_command.h"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) writeonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 9) buffer Bad { BadCards bad; };
layout(push_constant) uniform Push { uint haze_first, rgb_first; };

// Nonzero where one of four halves is: a full exponent carries into the bit above.
uvec2 bad_halves(uvec2 halves) { return ((halves & 0x7C007C00u) + 0x04000400u) & 0x80008000u; }

bool is_bad(Card c) {
  const uvec2 halves = bad_halves(c.sunlit) | bad_halves(c.ambient) | bad_halves(c.emission) | bad_halves(c.transmission) |
                       bad_halves(c.light) | bad_halves(c.motion);
  return is_bad(c.center) || is_bad(c.axis_u) || is_bad(c.axis_v) || is_bad(c.optical_depth) || is_bad(c.inv_feather) ||
         halves != uvec2(0u);
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint id = order[i];
  const Card card = cards[id];
  const bool counts = is_bad(card);
  if (counts) {
    atomicAdd(bad.count, 1u);
    atomicMin(bad.first, id);
  }
  const bool seen = !counts && (shows(card) || bends(card));
  pairs[i] = uvec2(!seen ? kUnseenSource : id >= rgb_first ? 2u : id >= haze_first ? 1u : 0u, id);
}
