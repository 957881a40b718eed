// Which squares of the walk have fragments of tilted cards: only those pay for joining them. A work group a square.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/fragment_list/fragment_list.h"
#include "methods/tile_sorted/tile_sorted.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 8) readonly buffer Heads { uint heads[]; };
layout(scalar, binding = 9) buffer Squares { WalkSquares squares; uint listed[]; };
layout(push_constant) uniform Push { uvec2 size; };

shared uint any_tilted;

void main() {
  if (gl_LocalInvocationIndex == 0u) any_tilted = 0u;
  barrier();
  bool found = false;
  for (uint i = gl_LocalInvocationIndex; i < kWalkSquare * kWalkSquare; i += 64u) {
    const uvec2 pixel = gl_WorkGroupID.xy * kWalkSquare + uvec2(i % kWalkSquare, i / kWalkSquare);
    if (all(lessThan(pixel, size))) found = found || heads[pixel.y * size.x + pixel.x] != kListEnd;
  }
  if (found) atomicOr(any_tilted, 1u);
  barrier();
  if (gl_LocalInvocationIndex != 0u) return;
  const uint which = any_tilted;
  listed[which * squares.number + atomicAdd(squares.groups[which][0], 1u)] = gl_WorkGroupID.x | gl_WorkGroupID.y << 16u;
}
