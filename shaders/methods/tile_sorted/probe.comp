// The probe: the product of what the tile's list and the pixel's own list let pass in front.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/fragment_list/sort.glsl"
#include "methods/tile_sorted/tile.glsl"
#include "probe/probe.glsl"

layout(constant_id = 0) const uint kTile = 16u;     // pixels
layout(constant_id = 1) const uint kTilted = 0u;
layout(constant_id = 2) const uint kTilesAcross = 1u;
layout(constant_id = 3) const uint kSpans = 1u;

vec3 probe_transmittance(uvec2 pixel, float depth) {
  vec3 t = vec3(1.0);
  const uvec2 tile = pixel / kTile, range = list_of(tile.y * kTilesAcross + tile.x, kSpans);
  const float opaque = texelFetch(opaque_depth, ivec2(pixel), 0).r;
  for (uint at = range.x; at < range.y; ++at) {
    const TileCard card = tile_cards[Entries(totals.address).ranks[at]];
    Fragment f;
    if (card.place.z < depth && fragment_of(card, vec2(pixel) + 0.5, opaque, f)) t *= transmittance(f);
  }
  if (kTilted == 0u) return t;
  Nodes list = Nodes(pool.address);
  for (uint node = heads[pixel.y * view.size.x + pixel.x]; node != kListEnd; node = list.nodes[node].next)
    if (list.nodes[node].depth < depth) t *= list.nodes[node].transmittance;
  return t;
}
