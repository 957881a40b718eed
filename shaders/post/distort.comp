// Haze bends the composed image: every pixel takes what lies at pixel + shift, filtered bilinearly. Shift is the methods' sum over
// haze of its own shift weighted by the transmittance in front of it (Drobot, SIGGRAPH 2025, "Extensions: distortion").
//   Opaque things in front of the haze stay where they are: a look-up that would touch one is left undisturbed.
// Limits: the image is composed before it bends, so that what is transparent in front of the haze is dragged as far as it lets the
// haze through.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 1) uniform sampler2D distortion;
layout(binding = 2) uniform sampler2D opaque_depth;
layout(binding = 3) uniform sampler2D composed;
layout(binding = 4, rgba16f) writeonly uniform image2D distorted;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, size))) return;
  const vec4 haze = texelFetch(distortion, ivec2(pixel), 0);
  vec4 color = texelFetch(composed, ivec2(pixel), 0);
  if (haze.w > 0.0 && haze.xy != vec2(0.0)) {
    const vec2 uv = (vec2(pixel) + 0.5 + haze.xy) / vec2(size);
    const vec4 depths = textureGather(opaque_depth, uv);   // near_m / view depth
    const float nearest = max(max(depths.x, depths.y), max(depths.z, depths.w));
    if (nearest * haze.w <= haze.z * view.near_m) color = textureLod(composed, uv, 0.0);
  }
  imageStore(distorted, ivec2(pixel), color);
}
