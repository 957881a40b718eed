// Cards grown by a pixel on every side: wherever a pixel's centre lies on the card, so do all its samples. With their planes, so
// that a fragment's depth comes out the same in every draw: see plane_depth.glsl. What shades them takes them as they are, so that
// which pixels they cover is decided as in every other method, to the last bit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"

layout(constant_id = 1) const uint kGrown = 1u;

// 1/m: at the middle of the picture, and how it grows to the right and down; a: the most of u + v on the card
layout(location = 7) flat out vec4 v_inverse_depth;

const float kLeastCosine = 0.05;   // cards seen from the side more than that are grown by less than a pixel

void main() {
  const uint id = card_id();
  const Card card = cards[id];
  if (!shows(card)) {
    place_nothing();
    return;
  }
  const vec3 normal = cross(card.axis_u, card.axis_v);
  const vec2 slope = vec2(dot(view.right, normal), -dot(view.up, normal)) * view.tan_half_fov;
  v_inverse_depth = vec4(vec3(dot(view.forward, normal), slope) / dot(card.center - view.camera, normal), is_triangle(card) ? 0.0 : 2.0);
  const vec2 uv = corner_of(card);
  if (kGrown == 0u) {
    place_vertex(card, id, uv);
    return;
  }
  const vec3 arm = card.center + card.axis_u * uv.x + card.axis_v * uv.y - view.camera;
  const float pixel_m = abs(dot(arm, view.forward)) * 2.0 * view.tan_half_fov.y / float(view.size.y);
  const float cosine = abs(dot(normalize(normal), normalize(arm)));
  const float grown_m = pixel_m / max(cosine, kLeastCosine);
  // Metres from the middle to the sides, across them: those along v, those along u, and the long one of a triangle.
  const vec3 sides = vec3(length(card.axis_v), length(card.axis_u), length(card.axis_u - card.axis_v));
  const vec3 grown = grown_m / max(length(normal) / max(sides, vec3(1e-9)), vec3(1e-4));
  vec2 place = uv * (1.0 + grown.xy);
  // The ends of the long side go on until they meet the other two, which have moved.
  if (is_triangle(card) && uv.x > 0.0) place.x = 1.0 + grown.y + grown.z;
  if (is_triangle(card) && uv.y > 0.0) place.y = 1.0 + grown.x + grown.z;
  place_vertex(card, id, place);
}
