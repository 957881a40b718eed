// What the splats of absorbance share: the fragment's absorbance, its place along its cell's ray, and the counts.
#ifndef PLUME_ABSORBANCE_SPLAT_GLSL
#define PLUME_ABSORBANCE_SPLAT_GLSL
#include "methods/parts/absorbance/counts.h"
#include "methods/parts/absorbance/fragment.glsl"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) readonly buffer Ranges { uvec2 ranges[]; };
layout(scalar, binding = 14) buffer Counts { AbsorbanceCounts counts; };

struct Splat {
  uvec2 cell;
  float place;
  vec3 absorbance;
};

// Discards what is hidden or absorbs nothing.
Splat splat() {
  if (hidden()) discard;
  const Fragment f = shade();
  const vec3 a = absorbance(f);
  if (all(lessThanEqual(a, vec3(0.0)))) discard;
  if (any(lessThan(passed_by(f), vec3(kLeastTransmittance)))) atomicAdd(counts.clamped, 1u);
  if (kCellRange == 0u && (f.depth < scene_range().x || f.depth > scene_range().y)) atomicAdd(counts.outside, 1u);
  const uvec2 cell = uvec2(gl_FragCoord.xy);
  return Splat(cell, place_in(kCellRange != 0u ? ranges[cell_index(cell)] : uvec2(0u), f.depth), a);
}

#endif
