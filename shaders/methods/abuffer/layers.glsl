// What the bounded A-buffer keeps of a fragment, and how it is rounded. A layer's key is a 64-bit word that orders by depth:
//   one transmittance:   depth 24 | transmittance 8 | light 11:11:10          light = premultiplied colour + emission
//   one for each channel: depth 24 | 0 | card 32,   beside a payload of light 11:11:10 and transmittance 11:11:10
// Depth is a half float (its 16 bits above 8 zeros), or the upper 24 bits of a float. 11:11:10 are floats without a sign, with 6, 6
// and 5 bits below the leading one, rounded to the nearest: light up to 64512 fits, so emission needs no other coding.
#ifndef PLUME_ABUFFER_LAYERS_GLSL
#define PLUME_ABUFFER_LAYERS_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/abuffer/bounded.h"

layout(constant_id = 0) const uint kLayers = 9u;
layout(constant_id = 1) const uint kRgb = 1u;         // a transmittance for each channel
layout(constant_id = 2) const uint kHalfDepth = 1u;   // instead of 24 bits
layout(scalar, binding = 8) buffer Bounded { BoundedLayers bounded; };
layout(scalar, binding = 9) buffer Counters { uint counters[]; };   // [pixel]
layout(buffer_reference, scalar, buffer_reference_align = 8) buffer Words { uvec2 words[]; };   // low, high

// Without `drop` of a half float's bits.
uint small_float(float v, uint drop) {
  const uint bits = packHalf2x16(vec2(clamp(v, 0.0, 65504.0), 0.0));
  return min((bits + (1u << (drop - 1u))) >> drop, 0x7bffu >> drop);
}
uint pack_11_11_10(vec3 v) { return small_float(v.r, 4u) | small_float(v.g, 4u) << 11 | small_float(v.b, 5u) << 22; }
vec3 unpack_11_11_10(uint word) {
  return vec3(unpackHalf2x16((word & 2047u) << 4 | (word >> 11 & 2047u) << 20), unpackHalf2x16((word >> 22) << 5).x);
}

uint depth_code(float depth) {
  return kHalfDepth != 0u ? packHalf2x16(vec2(min(depth, 65504.0), 0.0)) << 8 : floatBitsToUint(depth) >> 7;
}

struct Stored { uvec2 key, payload; };
struct Layer { vec3 light, transmittance; };

Stored encode(vec3 light, vec3 t, float depth, uint id) {
  const uint color = pack_11_11_10(light), far = depth_code(depth) << 8;
  if (kRgb != 0u) return Stored(uvec2(id, far), uvec2(color, pack_11_11_10(t)));
  return Stored(uvec2(color, far | uint(dot(t, vec3(255.0 / 3.0)) + 0.5)), uvec2(0u));
}

Layer decode(Stored stored) {
  if (kRgb != 0u) return Layer(unpack_11_11_10(stored.payload.x), unpack_11_11_10(stored.payload.y));
  return Layer(unpack_11_11_10(stored.key.x), vec3(float(stored.key.y & 255u) / 255.0));
}

bool is_free(uvec2 key) { return key == uvec2(kFree); }
bool changes_nothing(Layer layer) { return layer.light == vec3(0.0) && layer.transmittance == vec3(1.0); }

Stored read_layer(uint place) {
  return Stored(Words(bounded.keys).words[place], kRgb != 0u ? Words(bounded.payloads).words[place] : uvec2(0u));
}

#endif
