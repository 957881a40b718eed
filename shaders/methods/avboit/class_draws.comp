// AVBOIT, classify: the sorted cards as a draw order, and one indirect draw a class from the scanned counts of the sort.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/card_class.h"
#include "shared/workload.h"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) readonly buffer Pairs { uvec2 pairs[]; };
layout(scalar, binding = 1) writeonly buffer Order { uint order[]; };
layout(scalar, binding = 2) readonly buffer Counts { uint counts[]; };   // [digit][tile], scanned
layout(scalar, binding = 3) writeonly buffer ClassDraws { DrawCommand class_draws[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

void main() {
  const uint i = gl_GlobalInvocationID.x, count = work.count, sort_tiles = work.tiles.x;
  if (i < count) order[i] = pairs[i].y;
  if (i < kClasses) {
    const uint first = counts[i * sort_tiles];
    class_draws[i] = DrawCommand(4u, (i + 1u < kClasses ? counts[(i + 1u) * sort_tiles] : count) - first, 0u, first);
  }
}
