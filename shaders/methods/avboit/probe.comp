// AVBOIT's probe: the transmittance that a fragment without optical depth of its own would be drawn with. Draws read occupied
// slices only; between them the value stays what it is behind the last one.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/avboit/transmittance.glsl"
#include "probe/probe.glsl"

layout(constant_id = 3) const uint kSparse = 1u;
layout(constant_id = 4) const uint kEachChannel = 0u;   // 0: what is seen is weighted by one transmittance for all
layout(scalar, binding = 15) readonly buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

// The nearest place in front of p, or p, that has been integrated; negative where nothing lies in front.
float integrated_place(uint tile, float p) {
  if (kSparse == 0u) return p;
  for (int slice = int(p); slice >= 0; --slice) {
    uint mask = occupancy[tile * kMaskWords + slice / 32];
    if (kRgb != 0u) mask |= occupancy[(volume.tiles.x * volume.tiles.y + tile) * kMaskWords + slice / 32];
    if ((mask >> (slice % 32) & 1u) != 0u) return slice == int(p) ? p : float(slice) + 0.99999;
  }
  return -1.0;
}

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const uvec2 tile = pixel / (volume.divisor * kTileCells);
  const float p = integrated_place(tile.y * volume.tiles.x + tile.x, min(slice_at(depth), float(warp.used) - 0.001));
  vec3 t = p < 0.0 ? vec3(1.0) : transmittance_at(vec2(pixel) + 0.5, p, vec3(0.0));
  if (volume.exact_layers > 0u) {
    const vec3 layers_t = layers_in_front(pixel, depth, 0u, 0.0);
    t *= kEachChannel != 0u ? layers_t : vec3(dot(layers_t, vec3(1.0 / 3.0)));
  }
  return t;
}
