// Haze: hot air bends light outwards where a puff of it slopes, by an angle
//   theta = distortion * density * slope
// in the card's frame. Heat spreads faster than smoke, so the puff's detail is gone: both are means of four texels, kApart around. Light bent at depth z that comes from b is seen theta (1 - z / b) away from where it would be: nothing on
// contact, all of theta before the sky. b is the opaque surface's depth.
// Limits: small angles; the pixel's own background stands for the one that is looked up.
#ifndef PLUME_SURFACE_HAZE_GLSL
#define PLUME_SURFACE_HAZE_GLSL
#include "surface/shade.glsl"
#include "shared/card.h"
#include "shared/half.glsl"

layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };

const float kApart = 0.07;   // of the card's half width

// In pixels, x to the right and y down: what is seen here comes from pixel + shift.
vec2 haze_shift() {
  const Card card = cards[v_layers_id.z];
  const float bend = unpack_half4(card.motion).w;
  if (bend == 0.0) return vec2(0.0);
  const vec4 texel = 0.25 * (puff_texel(vec2(kApart, kApart)) + puff_texel(vec2(kApart, -kApart)) +
                             puff_texel(vec2(-kApart, kApart)) + puff_texel(vec2(-kApart, -kApart)));
  const vec2 slope = texel.gb * 2.0 - 1.0;
  const vec3 outwards = normalize(card.axis_u) * slope.x + normalize(card.axis_v) * slope.y;
  const float behind = 1.0 - v_uv_depth.z * texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r / view.near_m;
  const float pixels_a_radian = 0.5 * float(view.size.y) / view.tan_half_fov.y;
  const float most = 0.5 * float(view.size.y);
  const float theta = min(bend * density(texel) * clamp(behind, 0.0, 1.0) * pixels_a_radian, most);
  return theta * vec2(dot(outwards, view.right), -dot(outwards, view.up));
}

// What the output `distortion` sums, of a shift of which `part` is seen.
vec4 haze_sample(vec2 shift, float part) { return part * vec4(shift, length(shift) * vec2(1.0 / v_uv_depth.z, 1.0)); }

#endif
