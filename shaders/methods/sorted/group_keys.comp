// Sort keys of cards inside groups that a CPU has ordered: the group's rank in the high bits, what is left for the depth of the
// card's centre in the low ones. Limits: with many groups depth is coarse: of 2^b groups, it is as fine as a float of 32 - b bits.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/sorted/depth_key.glsl"
#include "methods/sorted/groups.glsl"

layout(local_size_x = 256) in;
layout(scalar, binding = 2) writeonly buffer Pairs { uvec2 pairs[]; };
layout(push_constant) uniform Push {
  uint count;
  uint group_count;
  uint rank_bits;
};

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  // What is not in front of the camera is not drawn: the sign bit would tell nothing.
  const uint depth = max(depth_key(i), 0x80000000u) & 0x7fffffffu;
  const uint rank = group_of(i, group_count).rank;
  pairs[i] = uvec2(rank_bits == 0u ? depth : rank << (32u - rank_bits) | depth >> (rank_bits - 1u), i);
}
