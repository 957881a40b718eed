// The depths between which each cell's absorbance lies.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/absorbance/fragment.glsl"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) buffer Ranges { uvec2 ranges[]; };

void main() {
  if (hidden()) return;
  const Fragment f = shade();
  if (all(lessThanEqual(absorbance(f), vec3(0.0)))) return;
  const uint cell = cell_index(uvec2(gl_FragCoord.xy));
  const uvec2 mine = pack_range(f.depth);
  atomicMax(ranges[cell].x, mine.x);
  atomicMax(ranges[cell].y, mine.y);
}
