// Masks to lists: the ranks of each tile's cards, front to back. Nothing is truncated: what does not fit is counted, the lists are
// grown by the host, and the frame is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/entries.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 10) readonly buffer Masks { uint masks[]; };
layout(push_constant, scalar) uniform Push { TileGrid grid; };

void main() {
  const uint at = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  if (at == 0u) totals.entries = counts[grid.tiles.x * grid.tiles.y * grid.spans];
  if (at >= grid.tiles.x * grid.tiles.y * grid.spans) return;
  const uint tile = at / grid.spans, first = (at % grid.spans) * kMaskSpan;
  Entries list = Entries(totals.address);
  uint place = counts[at];
  for (uint word = first; word < min(first + kMaskSpan, grid.words); ++word)
    for (uint mask = masks[tile * grid.words + word]; mask != 0u; mask &= mask - 1u) {
      if (place < totals.capacity) list.ranks[place] = word * 32u + uint(findLSB(mask));
      ++place;
    }
}
