// The probe of phenomenological transparency: as for WBOIT, the share of the fraction that an opaque white fragment would have,
//   w(z, 1) (1 - B) / sum a' w,   for each channel,
// and of a fragment of the picture what of its light reaches the pixel, self-modulation included.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(constant_id = 4) const uint kSelfModulation = 1u;   // 2 and 3 are the draw's
layout(binding = 8) uniform sampler2D accum;
layout(binding = 9) uniform sampler2D modulation;

#include "methods/phenomenological/weight.glsl"
#include "methods/phenomenological/self_modulation.glsl"
#include "methods/parts/weighted/contribution.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const float sum = texelFetch(accum, ivec2(pixel), 0).a;
  const vec3 b = texelFetch(modulation, ivec2(pixel), 0).rgb;
  if (sum <= 0.0) return contribution(vec3(1.0));
  const vec3 share = weight(depth, probed_alpha()) * (1.0 - b) / max(sum, 1e-5);
  return contribution(probed.card != kBareLight && kSelfModulation != 0u ? share * self_modulation(b) : share);
}
