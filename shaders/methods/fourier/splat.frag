// Fourier opacity mapping, first pass over the fragments: their absorbance into the series of their cell, blended additively.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/absorbance/splat.glsl"
#include "methods/fourier/series.glsl"

layout(location = 0) out vec4 series0;   // c, p_1, q_1, p_2
layout(location = 1) out vec4 series1;   // q_2, p_3, q_3, p_4 ...
layout(location = 2) out vec4 series2;
layout(location = 3) out vec4 series3;

void main() {
  const Splat s = splat();
  const float a = s.absorbance.r;
  const vec2 first = wave(in_period(s.place));
  vec2 waves[kMostPairs + 1u];
  waves[0] = vec2(1.0, 0.0);
  for (uint k = 1u; k <= kMostPairs; ++k) waves[k] = turned(first, waves[k - 1u]);
  series0 = a * vec4(1.0, waves[1], waves[2].x);
  series1 = a * vec4(waves[2].y, waves[3], waves[4].x);
  series2 = a * vec4(waves[4].y, waves[5], waves[6].x);
  series3 = a * vec4(waves[6].y, waves[7], 0.0);
}
