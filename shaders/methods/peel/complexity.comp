// Depth peeling: the depth complexity of the picture, from that of its pixels.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/peel/peel.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 8) buffer Counts { PeelCounts counts; };
layout(scalar, binding = 10) readonly buffer Depths { uint depths[]; };
layout(push_constant) uniform Push {
  uint pixels;
  uint most;   // layers that may be peeled
};

const uint kPixelsPerThread = 64u;

void main() {
  const uint first = gl_GlobalInvocationID.x * kPixelsPerThread;
  uint deepest = 0u, fragments = 0u, dropped = 0u;
  for (uint i = first; i < min(first + kPixelsPerThread, pixels); ++i) {
    deepest = max(deepest, depths[i]);
    fragments += depths[i];
    dropped += depths[i] - min(depths[i], most);
  }
  if (fragments == 0u) return;
  atomicMax(counts.deepest, deepest);
  atomicAdd(counts.fragments, fragments);
  atomicAdd(counts.dropped, dropped);
}
