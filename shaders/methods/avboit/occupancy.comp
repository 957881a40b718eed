// AVBOIT, occupancy: one bit a physical slice for every tile of cells that a card touches or reads, scalar and RGB sources apart.
// Conservative: bounding rectangles, grown by the cells that filtering reads.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/card_cells.glsl"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/sharp.glsl"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 11) buffer LayersStart { uint layers_start[]; };   // bits of the nearest depth of a sharp card, a tile
layout(scalar, binding = 10) buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint id = order[i];
  const Card card = cards[id];
  const Bounds b = bounds_of(card, view);
  if (!b.seen) return;
  const uint before = volume.guard_before, after = volume.guard_after;
  // A vertex far from the world's origin rounds its depth otherwise than the bounds do.
  const float rounding = 1e-6 * dot(abs(card.center) + abs(view.camera), vec3(1.0));
  const uint nearest = uint(slice_at(b.nearest - rounding)), farthest = uint(slice_at(b.farthest + rounding));
  const uint first = nearest - min(nearest, before), last = min(farthest + after, volume.slices - 1u);
  const uvec4 tiles = uvec4(cells_of(card, b, view, volume)) / kTileCells;
  const bool sharp = is_sharp(card, view, volume);
  const uint base = id >= volume.rgb_first && !sharp ? volume.tiles.x * volume.tiles.y : 0u;
  for (uint y = tiles.y; y <= tiles.w; ++y)
    for (uint x = tiles.x; x <= tiles.z; ++x) {
      if (sharp) atomicMin(layers_start[y * volume.tiles.x + x], floatBitsToUint(b.nearest));
      for (uint w = first / 32u; w <= last / 32u; ++w) {
        const uint from = w == first / 32u ? first & 31u : 0u, to = w == last / 32u ? last & 31u : 31u;
        const uint mask = (0xffffffffu >> (31u - to)) & (0xffffffffu << from);
        const uint word = (base + y * volume.tiles.x + x) * kMaskWords + w;
        if ((mask & ~occupancy[word]) != 0u) atomicOr(occupancy[word], mask);
      }
    }
}
