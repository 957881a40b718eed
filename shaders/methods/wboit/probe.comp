// WBOIT's probe: it knows no transmittance. What it gives an opaque white fragment at a depth is its share of the fraction,
//   w(z, 1) (1 - T) / sum a w,
// with the sums as they are, without that fragment. It may exceed 1. Of a fragment of the picture: what of its light reaches the pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/wboit/sums.glsl"
#include "methods/wboit/weight.glsl"
#include "methods/parts/weighted/contribution.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const Sums s = sums_at(ivec2(pixel));
  const float w = weight(depth, probed_alpha(), probed_light());
  return contribution(vec3(s.accum.a > 0.0 ? w * (1.0 - s.through.r) / max(s.accum.a, 1e-5) : 1.0));
}
