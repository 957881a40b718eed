// The values of sorted pairs as a draw order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/workload.h"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 1) writeonly buffer Order { uint order[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) order[i] = pairs[i].y;
}
