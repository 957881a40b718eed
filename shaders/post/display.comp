// Linear HDR to the displayed image: exposure, tone map, sRGB encoding, 8 bits.
// The ACES curve is Narkowicz's fit ("ACES Filmic Tone Mapping Curve", 2015); with tone map 0 values are clipped at 1.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 1) uniform sampler2D result;
layout(binding = 2, rgba8) writeonly uniform image2D display;
layout(push_constant) uniform Push { uvec2 size; };

vec3 aces(vec3 x) { return (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14); }

vec3 srgb(vec3 x) { return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, greaterThan(x, vec3(0.0031308))); }

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, size))) return;
  vec3 color = max(texelFetch(result, ivec2(pixel), 0).rgb * view.exposure, 0.0);
  if (view.tonemap == 1u) color = aces(min(color, 1e4));
  imageStore(display, ivec2(pixel), vec4(srgb(clamp(color, 0.0, 1.0)), 1.0));
}
