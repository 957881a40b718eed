// What weighted blending has summed at a pixel, whatever resolutions it was drawn at. Sums add and revealages multiply, so both mix in
// depth as if all had been drawn into one target. The includer declares kDivisor, of what was drawn at low resolution; 1: nothing was.
#ifndef PLUME_WEIGHTED_SUMS_GLSL
#define PLUME_WEIGHTED_SUMS_GLSL
#include "surface/low_resolution.glsl"

layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D through;
layout(binding = 10) uniform sampler2D emission;
layout(binding = 16) uniform sampler2D accum_low;
layout(binding = 17) uniform sampler2D through_low;
layout(binding = 18) uniform sampler2D emission_low;
layout(binding = 19) uniform sampler2D low_depth;
layout(binding = 20) uniform sampler2D full_depth;

struct Sums {
  vec4 accum;      // rgb: sum C a w   a: sum a w
  vec4 through;    // prod t
  vec3 emission;
};

Sums sums_at(ivec2 pixel) {
  Sums s = Sums(texelFetch(accum, pixel, 0), texelFetch(through, pixel, 0), texelFetch(emission, pixel, 0).rgb);
  if (kDivisor == 1u) return s;
  Sums low = Sums(vec4(0.0), vec4(0.0), vec3(0.0));
  const float here = texelFetch(full_depth, pixel, 0).r;
  float total = 0.0;
  for (int i = 0; i < 4; ++i) {
    const LowTap tap = low_tap(low_depth, pixel, kDivisor, here, i);
    low.accum += tap.weight * texelFetch(accum_low, tap.at, 0);
    low.through += tap.weight * texelFetch(through_low, tap.at, 0);
    low.emission += tap.weight * texelFetch(emission_low, tap.at, 0).rgb;
    total += tap.weight;
  }
  return Sums(s.accum + low.accum / total, s.through * low.through / total, s.emission + low.emission / total);
}

#endif
