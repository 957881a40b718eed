// Depth of field, second half: every pixel gathers the discs that cover it; a disc of radius r gives 1 / (pi r^2) of its light to each
// pixel of its area.
//   near: discs nearer than the pixel, over everything else as far as they cover it
//   same: discs of its own depth
//   back: what lies farther, within its own disc, shown as far as `same` leaves room: at the blurred edge of something
// A pixel in focus is covered by its own disc alone, so what is sharp stays as it is, to the bit, unless something nearer spreads over
// it. Samples lie on a golden spiral within the largest circle of the 3 x 3 tiles around.
// Limits: one depth a pixel; behind a blurred edge the background is what shows beside it; circles end at 1/16 of the height.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "post/lens.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 1) uniform sampler2D circles;
layout(binding = 2) uniform sampler2D circle_tiles;
layout(binding = 3) uniform sampler2D composed;
layout(binding = 4, rgba16f) writeonly uniform image2D blurred;
layout(push_constant, scalar) uniform Push { LensPush lens; };

const float kPi = 3.14159265, kGoldenAngle = 2.39996323;
const float kSharp = 0.5;       // radius of a disc no larger than its pixel
const float kSameDepth = 1.0;   // difference of radius, pixels

float largest_around(uvec2 pixel) {
  const ivec2 tile = ivec2(pixel / lens.tile_pixels);
  float largest = 0.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      largest = max(largest, texelFetch(circle_tiles, clamp(tile + ivec2(x, y), ivec2(0), ivec2(lens.tiles) - 1), 0).r);
  return largest;
}

float area(float radius) { return kPi * max(radius * radius, kSharp * kSharp); }

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, lens.size))) return;
  const vec3 own = texelFetch(composed, ivec2(pixel), 0).rgb;
  const float reach = largest_around(pixel);
  if (reach <= kSharp) {
    imageStore(blurred, ivec2(pixel), vec4(own, 1.0));
    return;
  }
  const float own_circle = texelFetch(circles, ivec2(pixel), 0).r;
  vec4 near = vec4(0.0), same = vec4(own, 1.0) * min(1.0 / area(own_circle), 1.0), back = vec4(0.0);
  const uint samples = clamp(uint(kPi * reach * reach), 16u, 160u);
  const float sample_area = kPi * reach * reach / float(samples);
  for (uint i = 0u; i < samples; ++i) {
    const float distance = reach * sqrt((float(i) + 0.5) / float(samples));
    const float angle = float(i) * kGoldenAngle;
    const ivec2 texel = ivec2(floor(vec2(pixel) + 0.5 + distance * vec2(cos(angle), sin(angle))));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(lens.size)))) continue;
    const float circle = texelFetch(circles, texel, 0).r;
    const float radius = circle < own_circle ? min(abs(circle), abs(own_circle)) : abs(circle);   // the pixel hides the rest of it
    const vec4 color = vec4(texelFetch(composed, texel, 0).rgb, 1.0);
    const float given = radius > kSharp ? clamp(radius - distance + 0.5, 0.0, 1.0) * sample_area / area(radius) : 0.0;
    if (circle > own_circle + kSameDepth) near += color * given;
    else if (circle >= own_circle - kSameDepth) same += color * given;
    else if (distance <= abs(own_circle)) back += color;
  }
  vec3 color = same.rgb / same.a;
  if (back.a > 0.0) color = mix(back.rgb / back.a, color, min(same.a, 1.0));
  if (near.a > 0.0) color = mix(color, near.rgb / near.a, min(near.a, 1.0));
  imageStore(blurred, ivec2(pixel), vec4(color, 1.0));
}
