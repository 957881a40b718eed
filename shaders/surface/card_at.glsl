// shade() in compute shaders: the fragment of a card at the centre of a pixel, found by crossing the pixel's ray with the card.
// Limits: pixels whose centre lies on a card's edge to within rounding may fall to the other side of it than in a draw.
#ifndef PLUME_SURFACE_CARD_AT_GLSL
#define PLUME_SURFACE_CARD_AT_GLSL
#include "shared/card.h"
#include "shared/half.glsl"

vec3 v_uv_depth;
vec4 v_sunlit, v_ambient, v_emission, v_transmission;
vec3 v_light;
uvec3 v_layers_id;
ivec2 g_shaded_pixel;

ivec2 shaded_pixel() { return g_shaded_pixel; }

#include "surface/shading.glsl"
#include "surface/card_varyings.glsl"

bool shows(Card card) { return card.optical_depth > 0.0 || card.emission != uvec2(0u); }

// Along the ray of a pixel's centre: the world moves by this a metre of view depth.
vec3 pixel_ray(ivec2 pixel) {
  const vec2 ndc = (vec2(pixel) + 0.5) / vec2(view.size) * 2.0 - 1.0;
  return view.forward + view.right * (ndc.x * view.tan_half_fov.x) - view.up * (ndc.y * view.tan_half_fov.y);
}

// False where there is none, or where it is behind the opaque surface.
bool shade_card_at(ivec2 pixel, Card card, uint id, out Fragment fragment) {
  const vec3 ray = pixel_ray(pixel), normal = cross(card.axis_u, card.axis_v);
  const float depth = dot(card.center - view.camera, normal) / dot(ray, normal);
  const vec3 from_center = view.camera + ray * depth - card.center;
  const vec2 uv = vec2(dot(cross(from_center, card.axis_v), normal), dot(cross(card.axis_u, from_center), normal)) / dot(normal, normal);
  if (!(depth >= view.near_m) || any(lessThan(uv, vec2(-1.0))) || any(greaterThanEqual(uv, vec2(1.0)))) return false;
  if (!shows(card) || view.near_m < depth * texelFetch(opaque_depth, pixel, 0).r) return false;
  v_uv_depth = vec3(uv, depth);
  g_shaded_pixel = pixel;
  set_varyings(card, id);
  const vec4 texel = puff_texel();
  const float density_here = density(texel);
  if (density_here <= 0.0) return false;
  fragment = shade_texel(texel, density_here);
  return true;
}

#endif
