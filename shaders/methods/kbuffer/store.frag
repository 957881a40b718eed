// k-buffer, second of two passes with 64-bit atomics: a fragment finds its key among the nearest and puts its light there. One that does
// not is of the tail.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/seen.glsl"
#include "methods/kbuffer/ordered_keys.glsl"
#include "methods/kbuffer/tail_targets.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

void main() {
  Fragment f;
  if (!shade_seen(f)) discard;
  const uint pixels = view.size.x * view.size.y, pixel = pixel_index(view.size);
  const uint64_t key = ordered_key(f);
  OrderedKeys keys = OrderedKeys(arrays.keys);
  uint low = 0u, high = kNodes - 1u;   // the first slot that is not nearer lies in between, unless all are
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (keys.at[middle * pixels + pixel] < key) low = middle + 1u;
    else high = middle;
  }
  const uint node = low * pixels + pixel;
  const bool stored = keys.at[node] == key;
  if (stored) {
    Vectors(arrays.light).at[node] = f.color + f.emission;
    Vectors(arrays.through).at[node] = transmittance(f);
    discard;
  }
  write_tail(f.color + f.emission, transmittance(f));
}
