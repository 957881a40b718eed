// Transmittance in front of a depth at a pixel, T = exp(-A): the cell's own A, or of larger cells the four around, filtered linearly
// before the exponential. A method defines absorbance_in_front().
#ifndef PLUME_ABSORBANCE_TRANSMITTANCE_GLSL
#define PLUME_ABSORBANCE_TRANSMITTANCE_GLSL
#include "methods/parts/absorbance/cells.glsl"

layout(scalar, binding = 8) readonly buffer Ranges { uvec2 ranges[]; };

const float kLeastWeight = 6.1e-6;   // e^-12: what shares a place and hides itself by far is mixed and does not turn black

uvec2 range_of(uvec2 cell) { return kCellRange != 0u ? ranges[cell_index(cell)] : uvec2(0u); }

// A at a depth in a cell, less what `own` absorbance at that depth adds to it.
vec3 absorbance_in_front(uvec2 cell, float depth, vec3 own);

vec3 transmittance_in_front(vec2 pixel, float depth, vec3 own) {
  if (kExcludeSelf == 0u) own = vec3(0.0);
  if (kDivisor == 1u) return exp(-max(absorbance_in_front(uvec2(pixel), depth, own), vec3(0.0)));
  const vec2 at = pixel / float(kDivisor) - 0.5, part = fract(at);
  const ivec2 last = ivec2(cells()) - 1;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 4; ++i) {
    const ivec2 corner = ivec2(i & 1, i >> 1);
    const vec2 share = mix(1.0 - part, part, vec2(corner));
    const uvec2 cell = uvec2(clamp(ivec2(floor(at)) + corner, ivec2(0), last));
    sum += share.x * share.y * max(absorbance_in_front(cell, depth, own), vec3(0.0));
  }
  return exp(-sum);
}

#endif
