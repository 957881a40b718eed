// Moments, depth bounds: the nearest and the farthest depth that any card on the screen has anywhere.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/moments/depth_warp.h"
#include "surface/bounds.glsl"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) buffer Ends { DepthBounds bounds; };

shared uint not_nearest, farthest;

void main() {
  if (gl_LocalInvocationIndex == 0u) not_nearest = farthest = 0u;
  barrier();
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) {
    const Bounds b = bounds_of(cards[order[i]], view);
    if (b.seen) {
      atomicMax(not_nearest, ~floatBitsToUint(b.nearest));
      atomicMax(farthest, floatBitsToUint(b.farthest));
    }
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u && farthest != 0u) {
    atomicMax(bounds.not_nearest, not_nearest);
    atomicMax(bounds.farthest, farthest);
  }
}
