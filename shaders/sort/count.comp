// Radix sort, step 1 of a round: how often each digit occurs in each tile. counts[digit * tiles + tile].
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/workload.h"

layout(local_size_x = kRadixThreads) in;
layout(scalar, binding = 0) readonly buffer Source { uvec2 source[]; };
layout(scalar, binding = 1) writeonly buffer Counts { uint counts[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };
layout(push_constant) uniform Push { uint shift; };   // of the digit

shared uint histogram[kRadixDigits];

void main() {
  const uint thread = gl_LocalInvocationID.x, tile = gl_WorkGroupID.x;
  if (thread < kRadixDigits) histogram[thread] = 0u;
  barrier();
  for (uint i = 0u; i < kRadixPerThread; ++i) {
    const uint at = tile * kRadixTile + i * kRadixThreads + thread;
    if (at < work.count) atomicAdd(histogram[(source[at].x >> shift) & (kRadixDigits - 1u)], 1u);
  }
  barrier();
  if (thread < kRadixDigits) counts[thread * work.tiles.x + tile] = histogram[thread];
}
