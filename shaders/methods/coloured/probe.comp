// The probe of coloured weighted blending: as for WBOIT, the share of the fraction that an opaque white fragment would have,
//   w(z, 1) (1 - prod(1 - a')) / sum a' w.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/coloured/sums.glsl"
#include "methods/coloured/weight.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const Sums s = sums_at(ivec2(pixel));
  return vec3(s.accum.a > 0.0 ? weight(depth, 1.0) * (1.0 - s.through.r) / s.accum.a : 1.0);
}
