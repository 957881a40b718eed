// Sort keys of cards: view depth of the centre; the value is the card's index.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/sorted/depth_key.glsl"

layout(local_size_x = 256) in;
layout(scalar, binding = 2) writeonly buffer Pairs { uvec2 pairs[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < count) pairs[i] = uvec2(depth_key(i), i);
}
