// The cells of the volume that a card touches or that filtering reads for it.
#ifndef PLUME_AVBOIT_CARD_CELLS_GLSL
#define PLUME_AVBOIT_CARD_CELLS_GLSL
#include "surface/bounds.glsl"
#include "methods/avboit/volume.h"

const vec2 kCorners[4] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(-1, 1), vec2(1, 1));   // a triangle has the first three

// Cells touched, as (first.xy, last.xy), grown by one for filtering and by one for cards that are widened to a cell.
ivec4 cells_of(Card card, Bounds b, ViewData view, Volume volume) {
  vec2 low = vec2(-1.0), high = vec2(1.0);
  if (b.nearest > view.near_m) {   // else it crosses the near plane: anywhere
    low = vec2(1e9), high = vec2(-1e9);
    for (uint i = 0u; i < (is_triangle(card) ? 3u : 4u); ++i) {
      const vec3 arm = card.center + card.axis_u * kCorners[i].x + card.axis_v * kCorners[i].y - view.camera;
      const vec2 ndc = vec2(dot(arm, view.right), -dot(arm, view.up)) / (dot(arm, view.forward) * view.tan_half_fov);
      low = min(low, ndc), high = max(high, ndc);
    }
  }
  const vec2 to_cells = vec2(view.size) * 0.5 / float(volume.divisor);
  const ivec2 last = ivec2(volume.cells) - 1;
  return ivec4(clamp(ivec2(floor((clamp(low, -1.0, 1.0) + 1.0) * to_cells)) - 2, ivec2(0), last),
               clamp(ivec2(floor((clamp(high, -1.0, 1.0) + 1.0) * to_cells)) + 2, ivec2(0), last));
}

#endif
