// AVBOIT, splat of RGB sources: the optical depth of each channel.
//   three words a slice: no event carries into another channel before an optical depth of a million;
//   one word, 8 bits each in 10-bit fields (the talk): the two spare bits hold four saturated events, more carry into the next
//   channel. The first overflowing slice is kept for each channel; behind it that channel is 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/splat_surface.glsl"

layout(constant_id = 3) const uint kPacked = 0u;
layout(scalar, binding = 10) buffer ExtinctionRgb { uint extinction_rgb[]; };
layout(scalar, binding = 11) buffer OverflowRgb { uint overflow_rgb[]; };   // [ray][channel], then [ray]: a carry

void add_packed(uint slice, uvec3 value) {
  const uint added = value.r | value.g << 10 | value.b << 20;
  if (added == 0u) return;
  const uint ray = ray_index();
  const uint old_word = atomicAdd(extinction_rgb[ray * volume.slices + slice], added);
  const uint carries = volume.cells.x * volume.cells.y * 3u;
  for (uint c = 0u; c < 3u; ++c) {
    const uint field = (old_word >> (10u * c)) & 1023u;
    if (field + value[c] > 255u) atomicMin(overflow_rgb[ray * 3u + c], slice);
    if (field + value[c] > 1023u) atomicMin(overflow_rgb[carries + ray], slice);
  }
}

void add_words(uint slice, uvec3 value) {
  const uint first = (ray_index() * volume.slices + slice) * 3u;
  for (uint c = 0u; c < 3u; ++c)
    if (value[c] != 0u) atomicAdd(extinction_rgb[first + c], value[c]);
}

void main() {
  if (hidden()) return;
  const vec3 through = passed_by(v_ambient.a * cell_density());
  const vec3 tau = -log(max(through, vec3(kLeastTransmittance)));
  const Place place = place_of(v_uv_depth.z);
  const uint bits = kPacked != 0u ? 8u : 32u;
  uvec3 here, beyond;
  for (uint c = 0u; c < 3u; ++c) {
    here[c] = quantise(tau[c] * (1.0 - place.beyond), bits, rounding(2u * c));
    beyond[c] = place.beyond > 0.0 ? quantise(tau[c] * place.beyond, bits, rounding(2u * c + 1u)) : 0u;
  }
  if (kPacked != 0u) {
    add_packed(place.slice, here);
    add_packed(place.slice + 1u, beyond);
  } else {
    add_words(place.slice, here);
    add_words(place.slice + 1u, beyond);
  }
}
