// AVBOIT, classify: what drawing each card has to do, in the order of submission, for a stable sort into one draw a class.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/card_class.h"
#include "methods/avboit/card_cells.glsl"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/sharp.glsl"
#include "methods/avboit/zero_tile.h"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(constant_id = 0) const uint kRgb = 1u;         // RGB sources have an integral of their own
layout(constant_id = 1) const uint kCullCards = 1u;   // leave out what lies wholly behind the zero-transmittance depth
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 10) readonly buffer RgbStart { uint rgb_start[]; };
layout(scalar, binding = 11) writeonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 12) readonly buffer ZeroDepths { float zero_depths[]; };
layout(scalar, binding = 13) readonly buffer LayersStart { uint layers_start[]; };   // bits of the nearest depth, a tile
layout(push_constant) uniform Push { uint rgb_first; };

bool behind_rgb(uvec4 tiles, Bounds b) {
  if (kRgb == 0u) return false;
  const uint last = uint(slice_at(b.farthest)) + volume.guard_after;
  for (uint y = tiles.y; y <= tiles.w; ++y)
    for (uint x = tiles.x; x <= tiles.z; ++x)
      if (rgb_start[y * volume.tiles.x + x] <= last) return true;
  return false;
}

bool behind_layers(uvec4 tiles, Bounds b) {
  if (volume.exact_layers == 0u) return false;
  for (uint y = tiles.y; y <= tiles.w; ++y)
    for (uint x = tiles.x; x <= tiles.z; ++x)
      if (layers_start[y * volume.tiles.x + x] < floatBitsToUint(b.farthest)) return true;
  return false;
}

bool behind_zero_depth(uvec4 cells, Bounds b) {
  const uint each = kZeroTilePixels / volume.divisor, across = (view.size.x + kZeroTilePixels - 1u) / kZeroTilePixels;
  const float nearest = view.near_m / b.nearest;
  const uvec4 tiles = cells / each;
  for (uint y = tiles.y; y <= tiles.w; ++y)
    for (uint x = tiles.x; x <= tiles.z; ++x)
      if (zero_depths[y * across + x] <= nearest) return false;
  return true;
}

uint class_of(uint id) {
  const Card card = cards[id];
  const Bounds b = bounds_of(card, view);
  if (!b.seen || (card.optical_depth <= 0.0 && card.emission == uvec2(0u))) return kClassUnseen;
  const uvec4 cells = uvec4(cells_of(card, b, view, volume));
  if (kCullCards != 0u && behind_zero_depth(cells, b)) return kClassUnseen;
  const uint lit_by = behind_rgb(cells / kTileCells, b) ? kBehindRgb : 0u;
  if (is_sharp(card, view, volume) || only_shines(card)) return 4u * kKindExact + kBehindLayers + lit_by;
  const bool plain = b.farthest - b.nearest <= 1e-4 * b.farthest && card.transmission == uvec2(0u);
  const uint kind = id >= rgb_first ? kKindRgb : plain ? kKindPlain : kKindGeneral;
  return 4u * kind + lit_by + (behind_layers(cells / kTileCells, b) ? kBehindLayers : 0u);
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) pairs[i] = uvec2(class_of(order[i]), order[i]);
}
