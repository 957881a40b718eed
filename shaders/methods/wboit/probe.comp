// WBOIT's probe: it knows no transmittance. What it gives an opaque white fragment at a depth is its share of the fraction,
//   w(z, 1) (1 - T) / sum a w,
// with the sums as they are, without that fragment. It may exceed 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D through;

#include "methods/wboit/weight.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const float sum = texelFetch(accum, ivec2(pixel), 0).a, t = texelFetch(through, ivec2(pixel), 0).r;
  return vec3(sum > 0.0 ? weight(depth, 1.0, vec3(1.0)) * (1.0 - t) / sum : 1.0);
}
