// The vertices of every transparent draw: four a card, a triangle strip, pulled from the card buffer in the given order. A triangle
// has its last corner twice: the strip's second half is empty.
#ifndef PLUME_SURFACE_CARD_GLSL
#define PLUME_SURFACE_CARD_GLSL
#include "shared/half.glsl"
#include "shared/view.h"
#include "surface/seen_cards.glsl"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };

layout(location = 0) out vec3 v_uv_depth;
layout(location = 1) flat out vec4 v_sunlit;         // rgb, a: layer blend
layout(location = 2) flat out vec4 v_ambient;        // rgb, a: optical depth
layout(location = 3) flat out vec4 v_emission;       // rgb, a: 1 / feather
layout(location = 4) flat out vec4 v_transmission;   // rgb, a: diffusion, radians
layout(location = 5) flat out vec3 v_light;
layout(location = 6) flat out uvec3 v_layers_id;     // two layers, card index

#include "surface/card_varyings.glsl"

layout(push_constant, scalar) uniform Push {
  uint backwards;   // 1: the last of the order first
  vec2 covered;      // share of the target that the picture fills
};

const vec2 kCorners[4] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1));

vec2 corner_of(Card card) { return kCorners[is_triangle(card) ? min(gl_VertexIndex, 2) : gl_VertexIndex]; }

uint card_id() { return order[backwards != 0u ? work.count - 1u - gl_InstanceIndex : gl_InstanceIndex]; }

void place_vertex(Card card, uint id, vec2 uv) {
  const vec3 world = card.center + card.axis_u * uv.x + card.axis_v * uv.y;
  gl_Position = view.view_projection * vec4(world, 1.0);
  gl_Position.xy = (gl_Position.xy + gl_Position.w) * covered - gl_Position.w;
  v_uv_depth = vec3(uv, dot(world - view.camera, view.forward));
  set_varyings(card, id);
}

void place_nothing() { gl_Position = vec4(0.0, 0.0, -1.0, 1.0); }   // in front of everything that is drawn: clipped

void place_card(Card card, uint id, bool drawn) {
  if (drawn) place_vertex(card, id, corner_of(card));
  else place_nothing();
}

// Of what can be seen.
void card_vertex() {
  const uint id = card_id();
  place_card(cards[id], id, shows(cards[id]));
}

// Of that, and of what only bends light.
void any_card_vertex() {
  const uint id = card_id();
  place_card(cards[id], id, shows(cards[id]) || bends(cards[id]));
}

#endif
