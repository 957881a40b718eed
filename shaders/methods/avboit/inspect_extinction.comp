// A look at what AVBOIT splatted: the optical depth of one slice of a cell, scalar sources and the mean of the channels of RGB ones.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/extinction.glsl"
#include "inspect/inspect.glsl"

layout(constant_id = 6) const uint kRgb = 0u;   // RGB sources are there
layout(scalar, binding = 9) readonly buffer WarpTable { DepthWarp warp; };

bool inspect(uvec2 pixel, out float value) {
  const uvec2 cell = pixel / volume.divisor, at = cell / kTileCells;
  const uint tile = at.y * volume.tiles.x + at.x, word = look.slice / 32u, bit = look.slice % 32u;
  const uint ray = cell.y * volume.cells.x + cell.x;
  const bool inside = look.slice < warp.used;
  const bool scalar = inside && (scalar_mask(tile, word) >> bit & 1u) != 0u;
  const bool rgb = inside && kRgb != 0u && (rgb_mask(tile, word) >> bit & 1u) != 0u;
  value = 0.0;
  if (scalar) value += scalar_depth(ivec2(cell), ray, look.slice);
  if (rgb) value += dot(rgb_depth(ivec2(cell), ray, look.slice), vec3(1.0 / 3.0));
  return scalar || rgb;
}
