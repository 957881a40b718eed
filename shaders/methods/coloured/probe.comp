// The probe of coloured weighted blending: as for WBOIT, the share of the fraction that an opaque white fragment would have,
//   w(z, 1) (1 - prod(1 - a')) / sum a' w,
// and of a fragment of the picture what of its light reaches the pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/coloured/sums.glsl"
#include "methods/coloured/weight.glsl"
#include "methods/parts/weighted/contribution.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const Sums s = sums_at(ivec2(pixel));
  const float w = weight(depth, probed_alpha());
  return contribution(vec3(s.accum.a > 0.0 ? w * (1.0 - s.through.r) / max(s.accum.a, 1e-5) : 1.0));
}
