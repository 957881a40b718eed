// Sort keys of cards: view depth of the centre, or the card's index, which is also the value.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/sorted/depth_key.glsl"

layout(local_size_x = kItemGroup) in;
layout(constant_id = 0) const uint kByDepth = 1u;
layout(scalar, binding = 9) writeonly buffer Pairs { uvec2 pairs[]; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) pairs[i] = uvec2(kByDepth != 0u ? depth_key(order[i]) : order[i], order[i]);
}
