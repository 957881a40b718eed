// Depth of field, first half: the circle of confusion of every pixel, and the largest of every tile. A thin lens of diameter A focused
// at F spreads a point at depth z over a disc that the picture shows with the diameter
//   c = A |1 / z - 1 / F| * pixels a radian,
// linear in 1 / z: so the mean inverse depth of what a pixel shows, transparent by its weight and opaque by the rest, gives the mean
// circle. Positive: nearer than the focus.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "post/lens.h"
#include "shared/view.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(binding = 1) uniform sampler2D surface;
layout(binding = 2) uniform sampler2D opaque_depth;
layout(binding = 3, r32f) writeonly uniform image2D circles;        // radius, pixels, signed
layout(binding = 4, r32f) writeonly uniform image2D circle_tiles;   // largest |radius|
layout(push_constant, scalar) uniform Push { LensPush lens; };

shared uint largest;   // bits of a float that is not negative: they order as it does

float radius_at(ivec2 pixel) {
  const vec2 transparent = texelFetch(surface, pixel, 0).rg;
  const float opaque = texelFetch(opaque_depth, pixel, 0).r / view.near_m;
  const float share = min(transparent.g, 1.0);
  const float inverse_depth = share > 0.0 ? mix(opaque, transparent.r / transparent.g, share) : opaque;
  const float pixels_a_radian = 0.5 * float(lens.size.y) / view.tan_half_fov.y;
  const float radius = 0.5 * lens.aperture_m * (inverse_depth - 1.0 / lens.focus_m) * pixels_a_radian;
  return clamp(radius, -float(lens.tile_pixels), float(lens.tile_pixels));
}

void main() {
  if (gl_LocalInvocationIndex == 0u) largest = 0u;
  barrier();
  const uvec2 first = gl_WorkGroupID.xy * lens.tile_pixels;
  const uvec2 end = min(first + lens.tile_pixels, lens.size);
  float most = 0.0;
  for (uint y = first.y + gl_LocalInvocationID.y; y < end.y; y += 8u)
    for (uint x = first.x + gl_LocalInvocationID.x; x < end.x; x += 8u) {
      const float radius = radius_at(ivec2(x, y));
      imageStore(circles, ivec2(x, y), vec4(radius));
      most = max(most, abs(radius));
    }
  atomicMax(largest, floatBitsToUint(most));
  barrier();
  if (gl_LocalInvocationIndex == 0u) imageStore(circle_tiles, ivec2(gl_WorkGroupID.xy), vec4(uintBitsToFloat(largest)));
}
