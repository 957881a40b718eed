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

// Half extent of the parallelogram along an axis.
float extent(Card card, vec3 axis) { return abs(dot(card.axis_u, axis)) + abs(dot(card.axis_v, axis)); }

Bounds bounds_of(Card card, ViewData view) {
  const vec3 arm = card.center - view.camera;
  const float depth = dot(arm, view.forward), thick = extent(card, view.forward);
  Bounds b = Bounds(false, max(depth - thick, view.near_m), depth + thick);
  const bool shows = card.optical_depth > 0.0 || card.emission != uvec2(0u) || (card.motion.y >> 16) != 0u;
  const float across = abs(dot(arm, view.right)) - extent(card, view.right);
  const float upright = abs(dot(arm, view.up)) - extent(card, view.up);
  b.seen = shows && b.farthest > view.near_m && across < b.farthest * view.tan_half_fov.x && upright < b.farthest * view.tan_half_fov.y;
  return b;
}
#endif
