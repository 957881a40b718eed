// AVBOIT's probe: the transmittance that a bare light or a fragment would be drawn with. Draws read slices that are occupied; between
// them the value stays what it is behind the last one.
// Limits: of what one channel of packed10 and rgb_splat can hold, a fragment's own share is taken out as if scalar lanes held it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/avboit/sharp.glsl"
#include "methods/avboit/transmittance.glsl"
#include "methods/avboit/integrated.glsl"
#include "probe/probe.glsl"

layout(constant_id = 4) const uint kEachChannel = 0u;   // 0: what is seen is weighted by one transmittance for all
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };

// Nothing was splatted around a depth that no slice holds: there the ray is read where it is.
bool in_empty_space(float depth) {
  const uint i = uint(virtual_slice(volume, warp.virtual_slices, warp.scale, depth));
  return nodes[i] == nodes[i + 1u];
}

vec3 around_light(uvec2 pixel, float depth) {
  const float p = slice_at(depth), end = float(warp.used) - 0.00001;
  const float place = kSampling == 4u && in_empty_space(depth) ? p - 0.00001 : reading_place(p);
  const float read = integrated(tile_of(pixel), min(place, end));
  if (read < 0.0) return vec3(1.0);
  const vec3 value = value_at((vec2(pixel) + 0.5) / vec2(volume.cells * volume.divisor), read);
  const vec3 t = kSampling == 4u ? exp(-value) : value;
  return kRgb == 0u ? t.rrr : t;
}

// As accumulate.frag does it. What lies in the exact layers is not in the volume.
vec3 around_fragment(uvec2 pixel, float depth, bool sharp) {
  const vec3 passed = kEachChannel != 0u ? probed.transmittance : vec3(dot(probed.transmittance, vec3(1.0 / 3.0)));
  const vec3 own = sharp ? vec3(0.0) : -log(max(passed, vec3(kLeastTransmittance)));
  return transmittance_at(vec2(pixel) + 0.5, slice_at(depth), own).transmittance;
}

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const bool bare = probed.card == kBareLight;
  const bool sharp = !bare && is_sharp(cards[bare ? 0u : probed.card], view, volume);
  vec3 t = vec3(0.0);
  if (bare) t = around_light(pixel, depth);
  else t = around_fragment(pixel, depth, sharp);
  if (volume.exact_layers > 0u) {
    bool estimated;
    const vec3 layers_t = layers_in_front(pixel, depth, bare ? 0u : probed.card, sharp ? tail_depth(pack_layer(probed.transmittance)) : vec3(0.0), estimated);
    t *= kEachChannel != 0u ? layers_t : vec3(dot(layers_t, vec3(1.0 / 3.0)));
  }
  return t;
}
