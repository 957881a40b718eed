// Radix sort, step 2 of a round: exclusive prefix sum of all counts, by one work group that walks them in chunks.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/workload.h"

layout(local_size_x = 256) in;
layout(scalar, binding = 1) buffer Counts { uint counts[]; };
layout(scalar, binding = 7) readonly buffer Work { Workload work; };

shared uint sums[256];

void main() {
  const uint thread = gl_LocalInvocationID.x;
  const uint total = kRadixDigits * work.tiles.x;
  const uint each = (total + 255u) / 256u;   // consecutive entries a thread
  const uint first = min(thread * each, total), last = min(first + each, total);
  uint sum = 0u;
  for (uint i = first; i < last; ++i) sum += counts[i];
  sums[thread] = sum;
  for (uint step = 1u; step < 256u; step *= 2u) {
    barrier();
    const uint other = thread >= step ? sums[thread - step] : 0u;
    barrier();
    sums[thread] += other;
  }
  uint running = sums[thread] - sum;
  for (uint i = first; i < last; ++i) {
    const uint count = counts[i];
    counts[i] = running;
    running += count;
  }
}
