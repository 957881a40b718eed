// Where a point at a pixel and a view depth was one tick ago on the screen: its own motion and the camera's.
#ifndef PLUME_SURFACE_MOTION_GLSL
#define PLUME_SURFACE_MOTION_GLSL
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/view.h"

// Pixels a tick, x to the right and y down; 0 where the point was not in front of the camera. No more than a picture's width
// and height: what came from farther was not seen either.
vec2 screen_motion(ViewData v, Card card, vec2 pixel, float depth) {
  const vec2 size = vec2(v.size), ndc = pixel / size * 2.0 - 1.0;
  const vec2 across = ndc * v.tan_half_fov * depth;
  const vec3 now = v.camera + v.forward * depth + v.right * across.x - v.up * across.y;
  const vec4 before = v.previous_view_projection * vec4(now - unpack_half4(card.motion).xyz, 1.0);
  if (before.w <= v.near_m) return vec2(0.0);
  return clamp(pixel - (before.xy / before.w * 0.5 + 0.5) * size, -size, size);
}

// What the output `surface` sums, of a fragment that shows `part` of itself.
vec4 surface_sample(float part, float depth, vec2 motion) { return part * vec4(1.0 / depth, 1.0, motion); }

#endif
