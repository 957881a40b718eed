// Seen cards, draws: the sorted cards as a draw order, and from the scanned counts of the sort how many there are: of all, to draw, and
// of each source.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/draw_command.h"
#include "shared/workload.h"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 1) readonly buffer Counts { uint counts[]; };   // [digit][tile], scanned
layout(scalar, binding = 2) writeonly buffer Order { uint order[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };
layout(scalar, binding = 8) writeonly buffer Draws { DrawCommand draws[]; };
layout(scalar, binding = 9) writeonly buffer Seen { Workload seen; };

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) order[i] = pairs[i].y;
  const uint tiles = work.tiles.x;
  if (i < kUnseenSource) {
    const uint first = counts[i * tiles];
    draws[1u + i] = DrawCommand(4u, counts[(i + 1u) * tiles] - first, 0u, first);
  }
  if (i == 0u) {
    const uint count = counts[kUnseenSource * tiles];
    draws[0] = DrawCommand(4u, count, 0u, 0u);
    seen = workload_of(count);
  }
}
