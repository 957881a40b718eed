// AVBOIT, zero-transmittance depth written by every pixel for itself, to compare with the quads: the same depths, but a shader that
// writes depth turns off early tests and compression.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/zero_tile.h"

layout(scalar, binding = 8) readonly buffer ZeroDepths { float zero_depths[]; };   // reversed, a tile; 0: none
layout(push_constant) uniform Push { uvec2 tiles; };

void main() {
  const uvec2 tile = uvec2(gl_FragCoord.xy) / kZeroTilePixels;
  gl_FragDepth = zero_depths[tile.y * tiles.x + tile.x];
}
