// AVBOIT, resolve:  image_c = (sum C a T_c) (1 - prod t_c + e) / (sum a_c T_c + e) + background prod t_c.
// The small e (kEpsilon) makes the fraction 1 where nothing covers, so that emission without coverage passes as it is. It vanishes as
// coverage grows: all weights may be small where much is in one slice.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/colour.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kNormalise = 1u;
layout(constant_id = 1) const uint kColour = kFullRgb;
layout(binding = 8) uniform sampler2D light;
layout(binding = 9) uniform sampler2D norm;
layout(binding = 13) uniform sampler2D norm_rgb;
layout(binding = 10) uniform sampler2D through;
layout(binding = 14) uniform sampler2D glow;
layout(binding = 11) uniform sampler2D opaque_color;
layout(binding = 12, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

const float kEpsilon = 1.0 / 1024.0;

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  const vec4 sums = texelFetch(light, pixel, 0);
  const vec4 tint = texelFetch(through, pixel, 0);
  const vec3 passed = sums.a * tint.rgb;
  vec3 covers = vec3(1.0 - sums.a * tint.a), covered = vec3(texelFetch(norm, pixel, 0).r), skew = vec3(1.0);
  if (kColour == kFullRgb) {
    covers = 1.0 - passed;
    covered += texelFetch(norm_rgb, pixel, 0).rgb;
  }
  if (kColour == kSkew || kColour == kFirstEvent) skew = tint.rgb / max(luma(tint.rgb), 1e-6);
  vec3 seen = sums.rgb * skew;
  const vec3 left = max(1.0 - covers, 0.0), e = kEpsilon * left * left + 1e-7;
  if (kNormalise != 0u) seen *= (covers + e) / (covered + e);
  seen += texelFetch(glow, pixel, 0).rgb;
  imageStore(result, pixel, vec4(seen + texelFetch(opaque_color, pixel, 0).rgb * passed, 1.0));
}
