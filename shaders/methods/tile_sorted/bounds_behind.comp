// Bounds of spans become bounds of a span and everything behind it, by one thread: spans are few.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/types.h"

layout(local_size_x = 1) in;
layout(scalar, binding = 9) buffer Bounds { vec2 bounds[]; };
layout(push_constant) uniform Push { uint spans; };

void main() {
  vec2 behind = vec2(0.0);
  for (uint i = spans; i-- > 0u;) {
    behind = vec2(max(behind.x, bounds[i].x), behind.y + bounds[i].y);
    bounds[i] = behind;
  }
}
