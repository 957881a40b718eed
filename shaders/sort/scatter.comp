// Radix sort, step 3 of a round: every pair goes to its place. A thread owns consecutive pairs and threads are ranked in order, so
// that equal digits keep their order.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/workload.h"

layout(local_size_x = kRadixThreads) in;
layout(scalar, binding = 0) readonly buffer Source { uvec2 source[]; };
layout(scalar, binding = 1) readonly buffer Counts { uint counts[]; };
layout(scalar, binding = 2) writeonly buffer Destination { uvec2 destination[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };
layout(push_constant) uniform Push { uint shift; };   // of the digit

shared uint places[kRadixDigits][kRadixThreads];

uint digit_of(uint key) { return (key >> shift) & (kRadixDigits - 1u); }

void main() {
  const uint thread = gl_LocalInvocationID.x, tile = gl_WorkGroupID.x;
  for (uint d = 0u; d < kRadixDigits; ++d) places[d][thread] = 0u;
  const uint first = tile * kRadixTile + thread * kRadixPerThread;
  const uint last = min(first + kRadixPerThread, work.count);
  for (uint i = first; i < last; ++i) places[digit_of(source[i].x)][thread] += 1u;
  barrier();
  if (thread < kRadixDigits) {
    uint running = counts[thread * work.tiles.x + tile];
    for (uint t = 0u; t < kRadixThreads; ++t) {
      const uint count = places[thread][t];
      places[thread][t] = running;
      running += count;
    }
  }
  barrier();
  for (uint i = first; i < last; ++i) {
    const uvec2 pair = source[i];
    const uint d = digit_of(pair.x);
    destination[places[d][thread]] = pair;
    places[d][thread] += 1u;
  }
}
