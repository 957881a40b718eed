// AVBOIT, exact layers: a fragment of a sharp card is inserted among the nearest of its pixel. Each slot takes the minimum and hands
// the displaced key on, so that whatever the order, the slots end as the nearest in order. What falls off the end is counted and
// merged into the tail of its pixel.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "surface/pixel.glsl"
#include "surface/shade.glsl"
#include "methods/avboit/exact_layers.h"
#include "methods/avboit/volume.h"

layout(early_fragment_tests) in;
layout(constant_id = 0) const uint kLayers = 4u;
layout(scalar, binding = 12) buffer Layers { uint64_t layers[]; };   // [layer][pixel]
layout(scalar, binding = 13) buffer LayerTails { uint merged; LayerTail tails[]; };   // fragments in tails, in all; [pixel]

void merge_into_tail(uint pixel, float depth, vec3 optical_depth) {
  atomicAdd(merged, 1u);
  atomicMax(tails[pixel].before, ~floatBitsToUint(depth));
  atomicMax(tails[pixel].farthest, floatBitsToUint(depth));
  const uvec3 steps = uvec3(optical_depth * kTailSteps + 0.5);
  const float mean = float(steps.r + steps.g + steps.b) / 3.0;
  if (tails[pixel].places < kTailFull) atomicAdd(tails[pixel].places, uint(mean * tail_place(depth) + 0.5));
  for (uint c = 0u; c < 3u; ++c)
    if (tails[pixel].depth[c] < kTailFull) atomicAdd(tails[pixel].depth[c], steps[c]);
}

void main() {
  const float coverage = coverage_of(density(puff_texel()));
  if (coverage <= 0.0) return;
  const vec3 through = 1.0 - coverage * (1.0 - v_transmission.rgb);
  uint64_t key = uint64_t(layer_place(v_uv_depth.z, v_layers_id.z)) << 32 | uint64_t(pack_layer(through));
  const uint pixels = view.size.x * view.size.y, pixel = pixel_index(view.size);
  for (uint k = 0u; k < kLayers; ++k) {
    const uint64_t old = atomicMin(layers[k * pixels + pixel], key);
    key = max(old, key);
    if (key == 0xfffffffffffffffful) return;
  }
  merge_into_tail(pixel, layer_depth(uint(key >> 32)), tail_depth(uint(key)));
}
