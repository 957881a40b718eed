// Whether a card on the screen can cover a pixel's centre in a box.
#ifndef PLUME_METHODS_TILE_SORTED_TOUCHES_GLSL
#define PLUME_METHODS_TILE_SORTED_TOUCHES_GLSL
#include "methods/tile_sorted/tile_sorted.h"

vec2 uv_at(vec4 pixel_to_uv, vec2 from_center) {
  return vec2(dot(pixel_to_uv.xy, from_center), dot(pixel_to_uv.zw, from_center));
}

// The box is no farther from the card's middle, along either of its axes, than both reach together.
bool touches(vec4 pixel_to_uv, vec2 card_center, vec2 box_center, vec2 half_box) {
  const vec2 apart = abs(uv_at(pixel_to_uv, box_center - card_center));
  const vec2 reach = vec2(dot(abs(pixel_to_uv.xy), half_box), dot(abs(pixel_to_uv.zw), half_box));
  return all(lessThanEqual(apart, 1.0 + reach));
}

#endif
