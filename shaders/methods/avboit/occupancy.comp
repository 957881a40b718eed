// AVBOIT, occupancy: one bit a physical slice for every tile of cells that a card touches or reads, scalar and RGB sources apart.
// Conservative: bounding rectangles, grown by the cells that filtering reads.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/bounds.glsl"
#include "methods/avboit/depth_warp.glsl"

layout(local_size_x = 256) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 10) buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

const vec2 kCorners[4] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1));

// Cells touched, as (first.xy, last.xy), grown by one for filtering and by one for cards that are widened to a cell.
ivec4 cells_of(Card card, Bounds b) {
  vec2 low = vec2(-1.0), high = vec2(1.0);
  if (b.nearest > view.near_m) {   // else it crosses the near plane: anywhere
    low = vec2(1e9), high = vec2(-1e9);
    for (uint i = 0u; i < 4u; ++i) {
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

void main() {
  const uint id = gl_GlobalInvocationID.x;
  if (id >= volume.cards) return;
  const Card card = cards[id];
  const Bounds b = bounds_of(card, view);
  if (!b.seen) return;
  const uint before = volume.guard_before, after = volume.guard_after;
  const uint nearest = uint(slice_at(b.nearest)), farthest = uint(slice_at(b.farthest));
  const uint first = nearest - min(nearest, before), last = min(farthest + after, volume.slices - 1u);
  const uvec4 tiles = uvec4(cells_of(card, b)) / kTileCells;
  const uint base = id >= volume.rgb_first ? volume.tiles.x * volume.tiles.y : 0u;
  for (uint y = tiles.y; y <= tiles.w; ++y)
    for (uint x = tiles.x; x <= tiles.z; ++x)
      for (uint w = first / 32u; w <= last / 32u; ++w) {
        const uint from = w == first / 32u ? first & 31u : 0u, to = w == last / 32u ? last & 31u : 31u;
        const uint mask = (0xffffffffu >> (31u - to)) & (0xffffffffu << from);
        const uint word = (base + y * volume.tiles.x + x) * kMaskWords + w;
        if ((mask & ~occupancy[word]) != 0u) atomicOr(occupancy[word], mask);
      }
}
