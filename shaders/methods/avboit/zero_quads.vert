// AVBOIT, depth quads: a tile behind whose depth nothing is seen, drawn into the depth buffer.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/zero_tile.h"

layout(scalar, binding = 8) readonly buffer ZeroTiles { ZeroTile zero_tiles[]; };
layout(push_constant) uniform Push { uvec2 size; };

const vec2 kCorners[4] = vec2[](vec2(0, 0), vec2(1, 0), vec2(0, 1), vec2(1, 1));

void main() {
  const ZeroTile t = zero_tiles[gl_InstanceIndex];
  const vec2 pixel = (vec2(t.tile) + kCorners[gl_VertexIndex]) * float(kZeroTilePixels);
  gl_Position = vec4(pixel / vec2(size) * 2.0 - 1.0, t.depth, 1.0);
}
