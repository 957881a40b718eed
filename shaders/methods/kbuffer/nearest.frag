// k-buffer, first of two passes with 64-bit atomics: the keys (depth, card) of a pixel's k nearest fragments, in order. Each slot takes
// the minimum and hands the displaced key on, so the slots end the same whatever the order.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/seen.glsl"
#include "methods/kbuffer/ordered_keys.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

void main() {
  Fragment f;
  if (!shade_seen(f)) return;
  const uint pixels = view.size.x * view.size.y, pixel = pixel_index(view.size);
  OrderedKeys keys = OrderedKeys(arrays.keys);
  uint64_t key = ordered_key(f);
  // Slots only ever shrink: what is behind the last one now stays behind it.
  if (keys.at[(kNodes - 1u) * pixels + pixel] < key) return;
  for (uint i = 0u; i < kNodes && key != kNoOrderedKey; ++i) key = max(key, atomicMin(keys.at[i * pixels + pixel], key));
}
