// AVBOIT, exact layers: a fragment of a sharp card is inserted among the nearest of its pixel. Each slot takes the minimum and hands
// the displaced key on, so that whatever the order, the slots end as the nearest in order. What falls off the end is counted and
// joins the volume with the share that its pixel has of the cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "surface/shade.glsl"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/exact_layers.h"
#include "methods/avboit/fields.glsl"

layout(early_fragment_tests) in;
layout(constant_id = 0) const uint kLayers = 4u;
layout(constant_id = 1) const uint kLaneBits = 16u;
layout(scalar, binding = 10) buffer Extinction { uint extinction[]; };
layout(scalar, binding = 11) buffer Overflow { uint overflow[]; };
layout(scalar, binding = 12) buffer Layers { uint64_t layers[]; };   // [layer][pixel]
layout(scalar, binding = 13) buffer LayersLost { uint layers_lost[]; };

void into_volume(float depth, vec3 through) {
  atomicAdd(layers_lost[0], 1u);
  const uvec2 cell = uvec2(gl_FragCoord.xy) / volume.divisor;
  const uint ray = cell.y * volume.cells.x + cell.x, lanes = 32u / kLaneBits;
  const uint slice = min(uint(slice_at(depth)), volume.slices - 1u);
  const float tau = -log(max(dot(through, vec3(1.0 / 3.0)), kLeastTransmittance)) / float(volume.divisor * volume.divisor);
  const uint added = quantise(tau, kLaneBits, 0.5), shift = kLaneBits * (slice % lanes);
  if (added == 0u) return;
  const uint old_word = atomicAdd(extinction[ray * (volume.slices / lanes) + slice / lanes], added << shift);
  if (kLaneBits != 32u && ((old_word >> shift) & full_field(kLaneBits)) + added > full_field(kLaneBits)) atomicMin(overflow[ray], slice);
}

void main() {
  const float coverage = coverage_of(density(puff_texel()));
  if (coverage <= 0.0) return;
  const vec3 through = 1.0 - coverage * (1.0 - v_transmission.rgb);
  uint64_t key = uint64_t(floatBitsToUint(v_uv_depth.z)) << 32 | uint64_t(pack_layer(through));
  const uint pixel = uint(gl_FragCoord.y) * view.size.x + uint(gl_FragCoord.x);
  for (uint k = 0u; k < kLayers; ++k) {
    const uint64_t old = atomicMin(layers[k * view.size.x * view.size.y + pixel], key);
    key = max(old, key);
    if (key == 0xfffffffffffffffful) return;
  }
  into_volume(uintBitsToFloat(uint(key >> 32)), unpack_layer(uint(key)));
}
