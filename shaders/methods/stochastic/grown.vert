// Cards grown by a pixel on every side: wherever a pixel's centre lies on the card, so do all its samples. With their planes, so
// that a fragment's depth comes out the same in every draw: see plane_depth.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/card.glsl"

layout(location = 7) flat out vec3 v_inverse_depth;   // 1/m: at the middle of the picture, and how it grows to the right and down

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
  v_inverse_depth = vec3(dot(view.forward, normal), slope) / dot(card.center - view.camera, normal);
  const vec2 uv = kCorners[gl_VertexIndex];
  const vec3 arm = card.center + card.axis_u * uv.x + card.axis_v * uv.y - view.camera;
  const float pixel_m = abs(dot(arm, view.forward)) * 2.0 * view.tan_half_fov.y / float(view.size.y);
  const float cosine = abs(dot(normalize(normal), normalize(arm)));
  const vec2 half_size = max(vec2(length(card.axis_u), length(card.axis_v)), vec2(1e-4));
  place_vertex(card, id, uv * (1.0 + pixel_m / max(cosine, kLeastCosine) / half_size));
}
