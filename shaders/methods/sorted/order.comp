// The values of sorted pairs as a draw order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/types.h"

layout(local_size_x = 256) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 1) writeonly buffer Order { uint order[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < count) order[i] = pairs[i].y;
}
