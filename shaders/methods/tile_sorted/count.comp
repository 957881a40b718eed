// How many cards each span of a tile's mask holds; a prefix sum makes them places in the lists.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/tile_sorted/tile_sorted.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 8) readonly buffer Masks { uint masks[]; };
layout(scalar, binding = 9) writeonly buffer Counts { uint counts[]; };
layout(push_constant, scalar) uniform Push {
  TileGrid grid;
  uint padded;   // counts in all; those after the last tile's are 0
};

void main() {
  const uint at = gl_GlobalInvocationID.x + gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x;
  if (at >= padded) return;
  const uint tile = at / grid.spans, first = (at % grid.spans) * kMaskSpan;
  uint sum = 0u;
  if (tile < grid.tiles.x * grid.tiles.y)
    for (uint word = first; word < min(first + kMaskSpan, grid.words); ++word) sum += bitCount(masks[tile * grid.words + word]);
  counts[at] = sum;
}
