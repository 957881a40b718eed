// Where the integral of a tile has a value for any place along the ray. Draws read slices that are occupied; between them the value
// stays what it is behind the last one.
#ifndef PLUME_AVBOIT_INTEGRATED_GLSL
#define PLUME_AVBOIT_INTEGRATED_GLSL
#include "methods/avboit/transmittance.glsl"

layout(constant_id = 3) const uint kSparse = 1u;
layout(scalar, binding = 15) readonly buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

uint tile_of(uvec2 pixel) {
  const uvec2 tile = pixel / (volume.divisor * kTileCells);
  return tile.y * volume.tiles.x + tile.x;
}

// The nearest place in front of `place`, or itself, that has been integrated; negative where nothing lies in front.
float integrated(uint tile, float place) {
  if (kSparse == 0u) return place;
  for (int slice = int(floor(place)); slice >= 0; --slice) {
    uint mask = occupancy[tile * kMaskWords + slice / 32];
    if (kRgb != 0u) mask |= occupancy[(volume.tiles.x * volume.tiles.y + tile) * kMaskWords + slice / 32];
    if ((mask >> (slice % 32) & 1u) != 0u) return min(place, float(slice) + 0.99999);
  }
  return -1.0;
}

#endif
