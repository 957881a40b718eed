// Conservative bounds of a card, as the camera sees it.
#ifndef PLUME_SURFACE_BOUNDS_GLSL
#define PLUME_SURFACE_BOUNDS_GLSL
#include "shared/card.h"
#include "shared/view.h"

struct Bounds {
  bool seen;       // false: nothing of it is drawn
  float nearest;   // view depth, m
  float farthest;
};

// How far the card reaches along an axis from its center: least and most.
vec2 extent(Card card, vec3 axis) {
  const float u = dot(card.axis_u, axis), v = dot(card.axis_v, axis), corner = abs(u) + abs(v), apart = abs(u - v);
  return is_triangle(card) ? vec2(min(-u - v, -apart), max(-u - v, apart)) : vec2(-corner, corner);
}

// Of a width to both sides of an axis, how far beyond it the card begins.
float beyond(vec2 reach, float at) { return max(at + reach.x, -at - reach.y); }

Bounds bounds_of(Card card, ViewData view) {
  const vec3 arm = card.center - view.camera;
  const float depth = dot(arm, view.forward);
  const vec2 thick = extent(card, view.forward);
  Bounds b = Bounds(false, max(depth + thick.x, view.near_m), depth + thick.y);
  const bool shows = card.optical_depth > 0.0 || card.emission != uvec2(0u) || (card.motion.y >> 16) != 0u;
  const float across = beyond(extent(card, view.right), dot(arm, view.right));
  const float upright = beyond(extent(card, view.up), dot(arm, view.up));
  b.seen = shows && b.farthest > view.near_m && across < b.farthest * view.tan_half_fov.x && upright < b.farthest * view.tan_half_fov.y;
  return b;
}
#endif
