// Reading and writing a pixel's nodes. They lie in no order; what orders them is their key.
#ifndef PLUME_PIXEL_NODES_GLSL
#define PLUME_PIXEL_NODES_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/parts/pixel_nodes/pixel_nodes.h"

layout(scalar, binding = 9) readonly buffer Arrays { NodeArrays arrays; };
layout(buffer_reference, scalar, buffer_reference_align = 8) coherent buffer Keys { uvec2 at[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) coherent buffer Vectors { vec3 at[]; };

const uvec2 kNoKey = uvec2(0xffffffffu);   // behind every other

bool in_front(uvec2 a, uvec2 b) { return a.y < b.y || (a.y == b.y && a.x < b.x); }
uvec2 node_key(float depth, uint id) { return uvec2(id, floatBitsToUint(depth)); }
float key_depth(uvec2 key) { return uintBitsToFloat(key.y); }

// Of `count` nodes the nearest that is not nearer than `least`, or kNoKey.
uvec2 nearest_from(uvec2 least, uint count, uint pixel, uint pixels, out uint node) {
  Keys keys = Keys(arrays.keys);
  uvec2 nearest = kNoKey;
  node = 0u;
  for (uint i = 0u; i < count; ++i) {
    const uvec2 key = keys.at[i * pixels + pixel];
    if (in_front(key, nearest) && !in_front(key, least)) {
      nearest = key;
      node = i;
    }
  }
  return nearest;
}

// The key that comes next to this one.
uvec2 key_after(uvec2 key) { return uvec2(key.x + 1u, key.x == 0xffffffffu ? key.y + 1u : key.y); }

#endif
