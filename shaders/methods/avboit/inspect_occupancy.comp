// A look at AVBOIT's occupancy: of a tile of cells, how many slices are occupied, by scalar or RGB sources; or of one slice (kOneSlice),
// 1 by scalar sources, 2 by RGB ones, 3 by both.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/occupied.glsl"
#include "inspect/inspect.glsl"

layout(constant_id = 1) const uint kOneSlice = 0u;
layout(scalar, binding = 9) readonly buffer WarpTable { DepthWarp warp; };

bool inspect(uvec2 pixel, out float value) {
  const uvec2 at = pixel / (volume.divisor * kTileCells);
  const uint tile = at.y * volume.tiles.x + at.x;
  uint number = 0u;
  if (kOneSlice != 0u) {
    const uint word = look.slice / 32u, bit = look.slice % 32u;
    if (look.slice < warp.used) number = (scalar_mask(tile, word) >> bit & 1u) | (rgb_mask(tile, word) >> bit & 1u) << 1;
  } else {
    for (uint word = 0u; word * 32u < warp.used; ++word) {
      const uint left = warp.used - word * 32u, in_use = left < 32u ? (1u << left) - 1u : 0xffffffffu;
      number += uint(bitCount((scalar_mask(tile, word) | rgb_mask(tile, word)) & in_use));
    }
  }
  value = float(number);
  return number > 0u;
}
