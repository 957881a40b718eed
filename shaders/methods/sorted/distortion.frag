// Distortion of sorted cards, back to front:  sum = shift + t * what is behind. Haze passes everything, the rest shifts nothing.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"

layout(location = 0, index = 0) out vec4 distortion;
layout(location = 0, index = 1) out vec4 through;

void main() {
  const vec2 shift = haze_shift();
  distortion = haze_sample(shift, 1.0);
  through = vec4(shift == vec2(0.0) ? 1.0 - gray_coverage(shade()) : 1.0);
}
