// AVBOIT, clear: zero extinction in the occupied slices of a tile, a work group a tile; the rest is never read.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/occupied.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const uint kLaneBits = 16u;
layout(constant_id = 2) const uint kRgbWords = 3u;   // a slice; 0: no extinction is kept for each channel
layout(scalar, binding = 11) writeonly buffer Extinction { uint extinction[]; };
layout(scalar, binding = 12) writeonly buffer ExtinctionRgb { uint extinction_rgb[]; };

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(cell, volume.cells))) return;
  const uint ray = cell.y * volume.cells.x + cell.x, lanes = 32u / kLaneBits, words = volume.slices / lanes;
  for (uint m = 0u; m < volume.slices / 32u; ++m) {
    for (uint mask = scalar_mask(tile_index(), m); mask != 0u;) {
      const uint word = uint(findLSB(mask)) / lanes;
      extinction[ray * words + m * kLaneBits + word] = 0u;
      mask &= ~(((1u << (lanes - 1u) << 1u) - 1u) << (word * lanes));
    }
    if (kRgbWords == 0u) continue;
    for (uint mask = rgb_mask(tile_index(), m); mask != 0u; mask &= mask - 1u) {
      const uint first = (ray * volume.slices + m * 32u + uint(findLSB(mask))) * kRgbWords;
      for (uint c = 0u; c < kRgbWords; ++c) extinction_rgb[first + c] = 0u;
    }
  }
}
