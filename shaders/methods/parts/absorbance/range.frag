// The depths between which each cell's absorbance lies.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/absorbance/fragment.glsl"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) buffer Ranges { uvec2 ranges[]; };

void main() {
  if (hidden()) return;
  const Fragment f = shade();
  if (all(lessThanEqual(absorbance(f), vec3(0.0)))) return;
  const uint cell = cell_index(uvec2(gl_FragCoord.xy));
  // Most fragments lie within what is known already: a plain read tells, and if it is old the atomics are right.
  const uvec2 mine = pack_range(f.depth), known = ranges[cell];
  if (mine.x > known.x) atomicMax(ranges[cell].x, mine.x);
  if (mine.y > known.y) atomicMax(ranges[cell].y, mine.y);
}
