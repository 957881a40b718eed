// A look at AVBOIT's zero-transmittance depth, m: of a cell, the end of the first slice behind which less than the zero transmittance is
// left; of a tile (kCulling), the depth in front of which fragments are drawn.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/zero_tile.h"
#include "shared/view.h"
#include "inspect/inspect.glsl"

layout(constant_id = 0) const uint kCulling = 0u;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 10) readonly buffer ZeroSlice { uint zero_slice[]; };
layout(scalar, binding = 11) readonly buffer ZeroDepths { float zero_depths[]; };   // reversed, a tile; 0: none

bool inspect(uvec2 pixel, out float value) {
  if (kCulling != 0u) {
    const uvec2 tile = pixel / kZeroTilePixels;
    const float reversed = zero_depths[tile.y * ((look.size.x + kZeroTilePixels - 1u) / kZeroTilePixels) + tile.x];
    value = view.near_m / max(reversed, 1e-9);
    return reversed > 0.0;
  }
  const uvec2 cell = pixel / volume.divisor;
  const uint slice = zero_slice[cell.y * volume.cells.x + cell.x];
  value = slice_ends[min(slice, kMostSlices - 1u)];
  return slice != kNoSlice;
}
