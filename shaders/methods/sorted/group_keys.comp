// Sort keys of cards by groups that a CPU has ordered. Sorted inside each group: the group's rank in the high bits, what is left for the
// depth of the card's centre in the low ones. Otherwise the rank alone, the last submitted first. Limits: with many groups depth is
// coarse: of 2^b groups, it is as fine as a float of 32 - b bits.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/sorted/depth_key.glsl"
#include "methods/sorted/groups.h"

layout(local_size_x = kItemGroup) in;
layout(constant_id = 0) const uint kByDepth = 1u;
layout(scalar, binding = 8) readonly buffer Groups { OrderedGroup groups[]; };
layout(scalar, binding = 9) writeonly buffer Pairs { uvec2 pairs[]; };
layout(push_constant) uniform Push {
  uint group_count;
  uint rank_bits;
};

uint rank_of(uint card) {
  uint low = 0u, high = group_count;   // the last group whose first card is not behind `card`
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (groups[middle].first <= card) low = middle;
    else high = middle;
  }
  return groups[low].rank;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint card = order[i], rank = rank_of(card);
  if (kByDepth == 0u) {
    pairs[work.count - 1u - i] = uvec2(rank, card);
    return;
  }
  // What is not in front of the camera is not drawn: the sign bit would tell nothing.
  const uint depth = max(depth_key(card), 0x80000000u) & 0x7fffffffu;
  pairs[i] = uvec2(rank_bits == 0u ? depth : rank << (32u - rank_bits) | depth >> (rank_bits - 1u), card);
}
