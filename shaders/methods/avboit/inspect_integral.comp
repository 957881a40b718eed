// A look at AVBOIT's integral: the transmittance behind one slice, filtered across cells as draws read it, the mean of the channels. The
// exact layers are not in it. Draws stand in slices that all cells around them have; elsewhere a cell may have a slice that its neighbour
// was never asked for, and is shown by itself.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/avboit/integrated.glsl"
#include "inspect/inspect.glsl"

// Whether all cells that the filter reads at a pixel have this slice.
bool has_neighbours(uvec2 pixel, uint slice) {
  const ivec2 first = ivec2(floor((vec2(pixel) + 0.5) / float(volume.divisor) - 0.5));
  for (int i = 0; i < 4; ++i) {
    const uvec2 cell = uvec2(clamp(first + ivec2(i & 1, i >> 1), ivec2(0), ivec2(volume.cells) - 1));
    const uvec2 tile = cell / kTileCells;
    if (uint(max(integrated(tile.y * volume.tiles.x + tile.x, float(slice)), -1.0) + 1.0) != slice + 1u) return false;
  }
  return true;
}

mat3x2 nodes_of_cell(uvec2 cell, uint slice) {
  const ivec3 at = ivec3(cell, slice);
  if (kRgb == 0u) return mat3x2(texelFetch(integral, at, 0).rg, vec2(0.0), vec2(0.0));
  const vec4 rg = texelFetch(integral_rg, at, 0);
  return mat3x2(rg.rg, rg.ba, texelFetch(integral_b, at, 0).rg);
}

bool inspect(uvec2 pixel, out float value) {
  value = 1.0;
  if (look.slice >= warp.used) return false;
  const float place = integrated(tile_of(pixel), float(look.slice));
  if (place < 0.0) return true;
  const uint slice = uint(place);
  const mat3x2 nodes = has_neighbours(pixel, slice) ? nodes_of((vec2(pixel) + 0.5) / vec2(volume.cells * volume.divisor), slice)
                                                    : nodes_of_cell(pixel / volume.divisor, slice);
  const vec3 behind = vec3(nodes[0].y, nodes[1].y, nodes[2].y), t = kSampling == 4u ? exp(-behind) : behind;
  value = kRgb != 0u ? dot(t, vec3(1.0 / 3.0)) : t.r;
  return true;
}
