// Keeps the nearest: each layer takes the minimum of its key and hands the greater one on, so that whatever the order of draws,
// the layers end as the nearest fragments, front to back. Keys only ever fall, so a layer seen in front stays in front: passing it
// needs no atomic.
#ifndef PLUME_ABUFFER_NEAREST_GLSL
#define PLUME_ABUFFER_NEAREST_GLSL
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "methods/abuffer/layers.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 8) buffer Keys { uint64_t keys[]; };

// Gives the key that finds no place in the end, this or another; or kFree.
uvec2 insert_nearest(uint pixel, uint pixels, uvec2 wanted) {
  Keys layers = Keys(bounded.keys);
  uint64_t key = uint64_t(wanted.y) << 32 | uint64_t(wanted.x);
  if (layers.keys[(kLayers - 1u) * pixels + pixel] > key) {
    for (uint k = 0u; k < kLayers && key != 0xfffffffffffffffful; ++k) {
      const uint place = k * pixels + pixel;
      if (layers.keys[place] > key) key = max(key, atomicMin(layers.keys[place], key));
    }
  }
  return uvec2(uint(key), uint(key >> 32));
}

#endif
