// A look at AVBOIT's first-overflow depth, m: the end of the first slice of a cell whose field overflowed, in any channel. From that
// slice on every slice counts as full.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/depth_warp.glsl"
#include "inspect/inspect.glsl"

layout(constant_id = 0) const uint kRgb = 0u;   // packed RGB fields note it too
layout(scalar, binding = 10) readonly buffer Overflow { uint overflow[]; };
layout(scalar, binding = 11) readonly buffer OverflowRgb { uint overflow_rgb[]; };   // [ray][channel]

bool inspect(uvec2 pixel, out float value) {
  const uvec2 cell = pixel / volume.divisor;
  const uint ray = cell.y * volume.cells.x + cell.x;
  uint first = overflow[ray];
  if (kRgb != 0u) first = min(first, min(overflow_rgb[ray * 3u], min(overflow_rgb[ray * 3u + 1u], overflow_rgb[ray * 3u + 2u])));
  value = slice_ends[min(first, max(warp.used, 1u) - 1u)];
  return first != kNoOverflow;
}
