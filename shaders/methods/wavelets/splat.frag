// Wavelet transparency, first pass over the fragments: their absorbance into the coefficients of their cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/absorbance/fragment.glsl"
#include "methods/wavelets/haar.glsl"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) readonly buffer Ranges { uvec2 ranges[]; };

void main() {
  if (hidden()) return;
  const Fragment f = shade();
  const vec3 a = absorbance(f);
  if (all(lessThanEqual(a, vec3(0.0)))) return;
  if (any(lessThan(passed_by(f), vec3(kLeastTransmittance)))) atomicAdd(sums.clamped, 1u);
  if (kCellRange == 0u && (f.depth < scene_range().x || f.depth > scene_range().y)) atomicAdd(sums.outside, 1u);
  const uvec2 cell = uvec2(gl_FragCoord.xy);
  add_step(cell, place_in(kCellRange != 0u ? ranges[cell_index(cell)] : uvec2(0u), f.depth), a);
}
