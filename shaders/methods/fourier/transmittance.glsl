// Fourier opacity mapping, the transmittance in front of a depth: read where fragments are drawn and where the probe asks.
#ifndef PLUME_FOURIER_TRANSMITTANCE_GLSL
#define PLUME_FOURIER_TRANSMITTANCE_GLSL
#include "methods/parts/absorbance/transmittance.glsl"
#include "methods/fourier/series.glsl"

layout(binding = 10) uniform sampler2D series0;
layout(binding = 11) uniform sampler2D series1;
layout(binding = 12) uniform sampler2D series2;   // where kPairs > 3
layout(binding = 13) uniform sampler2D series3;   // where kPairs > 5

vec3 absorbance_in_front(uvec2 cell, float depth, vec3 own) {
  const float place = place_in(range_of(cell), depth), x = in_period(place);
  const ivec2 at = ivec2(cell);
  const vec4 s0 = texelFetch(series0, at, 0), s1 = texelFetch(series1, at, 0);
  const vec4 s2 = kPairs > 3u ? texelFetch(series2, at, 0) : vec4(0.0), s3 = kPairs > 5u ? texelFetch(series3, at, 0) : vec4(0.0);
  const vec2 pairs[kMostPairs] = vec2[](s0.yz, vec2(s0.w, s1.x), s1.yz, vec2(s1.w, s2.x), s2.yz, vec2(s2.w, s3.x), s3.yz);
  const vec2 first = wave(x);
  vec2 now = first;
  float sum = s0.x * x;
  for (uint k = 1u; k <= kPairs; ++k) {
    sum += (pairs[k - 1u].x * now.y + pairs[k - 1u].y * (1.0 - now.x)) / (kPi * float(k));
    now = turned(first, now);
  }
  return vec3(sum - own.r * (place == kBehind ? 1.0 : own_share(x)));
}

#endif
