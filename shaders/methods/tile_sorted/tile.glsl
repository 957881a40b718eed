// Reading a tile's list at a pixel: what covers it there, front to back, with the colours of shade().
#ifndef PLUME_METHODS_TILE_SORTED_TILE_GLSL
#define PLUME_METHODS_TILE_SORTED_TILE_GLSL
#include "methods/tile_sorted/entries.glsl"
#include "methods/tile_sorted/touches.glsl"
#include "shared/card.h"
#include "surface/shade_at.glsl"

layout(scalar, binding = 10) readonly buffer TileCards { TileCard tile_cards[]; };

uvec2 list_of(uint tile, uint spans) {
  return min(uvec2(counts[tile * spans], counts[(tile + 1u) * spans]), totals.capacity);
}

uint id_of(TileCard card) { return floatBitsToUint(card.light.w); }

// The fragment of a card at a pixel's centre; false where it has none, or where it is behind the opaque surface.
bool fragment_of(TileCard card, vec2 center, float opaque, out Fragment fragment) {
  const vec2 uv = uv_at(card.pixel_to_uv, center - card.place.xy);
  v_uv_depth = vec3(uv, card.place.z);
  v_sunlit = card.sunlit;
  v_ambient = card.ambient;
  v_emission = card.emission;
  v_transmission = card.transmission;
  v_light = card.light.xyz;
  const uint layers = floatBitsToUint(card.transmission.w), layer_mask = (1u << kLayerBits) - 1u;
  v_layers_id = uvec3(layers & layer_mask, (layers >> kLayerBits) & layer_mask, id_of(card));
  v_opaque = opaque;
  return shade_at(fragment) && all(greaterThanEqual(uv, vec2(-1.0))) && all(lessThan(uv, vec2(1.0))) &&
         card.place.z * opaque <= view.near_m;
}

#endif
