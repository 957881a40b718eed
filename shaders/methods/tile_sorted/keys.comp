// Which cards join the tiles, and their sort keys: view depth as an unsigned integer of the same order; the value is the card's
// index. A card joins when it faces the camera, so that one depth holds all over it, and is a whole parallelogram. What is tilted
// and what is a triangle is drawn and captured instead.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/tile_sorted.h"
#include "shared/draw_command.h"
#include "shared/view.h"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) writeonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 9) buffer Totals { TileTotals totals; };
layout(scalar, binding = 10) buffer TiltedDraw { DrawCommand tilted_draw; };
layout(scalar, binding = 11) writeonly buffer TiltedOrder { uint tilted_order[]; };

const float kFacing = 1e-5;   // of a card's size: what it may lean, above rounding

bool faces_camera(Card card) {
  return (card.layers & kCardTriangle) == 0u &&
         abs(dot(card.axis_u, view.forward)) <= kFacing * length(card.axis_u) &&
         abs(dot(card.axis_v, view.forward)) <= kFacing * length(card.axis_v);
}

// The box around a facing card meets the picture.
bool is_on_screen(Card card, float depth) {
  const vec3 arm = card.center - view.camera;
  const vec2 at = vec2(dot(arm, view.right), dot(arm, view.up));
  const vec2 reach = abs(vec2(dot(card.axis_u, view.right), dot(card.axis_u, view.up))) +
                     abs(vec2(dot(card.axis_v, view.right), dot(card.axis_v, view.up)));
  return depth >= view.near_m && all(lessThan(abs(at) - reach, view.tan_half_fov * depth));
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint id = order[i];
  const Card card = cards[id];
  const bool shown = shows(card), faces = faces_camera(card);
  const float depth = dot(card.center - view.camera, view.forward);
  const bool joins = shown && faces && is_on_screen(card, depth);
  pairs[i] = uvec2(joins ? floatBitsToUint(depth) : kNotInTiles, id);
  if (joins) atomicAdd(totals.cards, 1u);
  if (shown && !faces) {
    tilted_order[atomicAdd(tilted_draw.instances, 1u)] = id;
    atomicAdd(totals.tilted, 1u);
  }
}
