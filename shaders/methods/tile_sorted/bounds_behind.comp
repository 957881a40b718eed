// Bounds of spans become bounds of a span and everything behind it, by one thread: spans are few.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/tile_sorted.h"
#include "shared/workload.h"

layout(local_size_x = 1) in;
layout(scalar, binding = 9) buffer Bounds { vec2 bounds[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

void main() {
  vec2 behind = vec2(0.0);
  for (uint i = (work.count + kBoundSpan - 1u) / kBoundSpan; i-- > 0u;) {
    behind = vec2(max(behind.x, bounds[i].x), behind.y + bounds[i].y);
    bounds[i] = behind;
  }
}
