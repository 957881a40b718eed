// The inverse Haar transform, in place: coefficients become means over leaves, which then cost a read each and not a walk. A thread
// a cell and channel; what dims all channels alike is added to each.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/wavelets/haar.glsl"

layout(local_size_x = 8, local_size_y = 8) in;   // z: channel

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(cell, cells()))) return;
  Coefficients all = Coefficients(address);
  const uint first = coefficient(cell, 0u), of_channel = first + (kChannels == 3u ? 1u + gl_GlobalInvocationID.z : 0u);
  if (all.c[of_channel] + all.c[first] == 0.0) return;   // no scale term: nothing is there
  float means[kLeaves];
  for (uint n = 0u; n < kLeaves; ++n)
    means[n] = all.c[of_channel + n * kSums] + (kChannels == 3u ? all.c[first + n * kSums] : 0.0);
  // From the first 2^level entries, means over that level's nodes, and as many differences behind them, to the next level's.
  float next[kLeaves];
  for (uint level = 0u; level <= kRank; ++level) {
    const uint nodes = 1u << level;
    for (uint k = 0u; k < nodes; ++k) {
      next[2u * k] = means[k] + means[nodes + k];
      next[2u * k + 1u] = means[k] - means[nodes + k];
    }
    for (uint k = 0u; k < 2u * nodes; ++k) means[k] = next[k];
  }
  for (uint n = 0u; n < kLeaves; ++n) all.c[of_channel + n * kSums] = means[n];
}
