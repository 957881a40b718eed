// The probe of phenomenological transparency: as for WBOIT, the share of the fraction that an opaque white fragment would have,
//   w(z, 1) (1 - B) / sum a' w,   for each channel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D modulation;

#include "methods/phenomenological/weight.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const float sum = texelFetch(accum, ivec2(pixel), 0).a;
  const vec3 covers = 1.0 - texelFetch(modulation, ivec2(pixel), 0).rgb;
  return sum > 0.0 ? weight(depth, 1.0) * covers / sum : vec3(1.0);
}
