// AVBOIT's probe: the transmittance that a fragment without optical depth of its own would be drawn with. Draws read slices that are
// occupied; between them the value stays what it is behind the last one.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/avboit/transmittance.glsl"
#include "probe/probe.glsl"

layout(constant_id = 3) const uint kSparse = 1u;
layout(constant_id = 4) const uint kEachChannel = 0u;   // 0: what is seen is weighted by one transmittance for all
layout(scalar, binding = 15) readonly buffer Occupancy { uint occupancy[]; };   // [scalar, rgb][tile][kMaskWords]

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

// Nothing was splatted around a depth that no slice holds: there the ray is read where it is.
bool in_empty_space(float depth) {
  const uint i = uint(virtual_slice(volume, warp.virtual_slices, warp.scale, depth));
  return nodes[i] == nodes[i + 1u];
}

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const uvec2 tile = pixel / (volume.divisor * kTileCells);
  const float p = slice_at(depth), end = float(warp.used) - 0.00001;
  const float place = kSampling == 4u && in_empty_space(depth) ? p - 0.00001 : reading_place(p);
  const float read = integrated(tile.y * volume.tiles.x + tile.x, min(place, end));
  vec3 t = vec3(1.0);
  if (read >= 0.0) {
    const vec3 value = value_at((vec2(pixel) + 0.5) / vec2(volume.cells * volume.divisor), read);
    t = kSampling == 4u ? exp(-value) : value;
    if (kRgb == 0u) t = t.rrr;
  }
  if (volume.exact_layers > 0u) {
    const vec3 layers_t = layers_in_front(pixel, depth, 0u, 0.0);
    t *= kEachChannel != 0u ? layers_t : vec3(dot(layers_t, vec3(1.0 / 3.0)));
  }
  return t;
}
