// Appending to the lists: a fragment beyond the capacity is counted, not stored.
#ifndef PLUME_METHODS_REFERENCE_LIST_GLSL
#define PLUME_METHODS_REFERENCE_LIST_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/parts/fragment_list/fragment_list.h"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) buffer Pool { FragmentPool pool; };
layout(scalar, binding = 9) buffer Heads { uint heads[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Nodes { FragmentNode nodes[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Extras { vec2 extras[]; };

// Gives the node's place, which may be beyond the capacity.
uint append(FragmentNode node) {
  const uint slot = atomicAdd(pool.count, 1u);
  if (slot >= pool.capacity) return slot;
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  node.next = atomicExchange(heads[pixel.y * view.size.x + pixel.x], slot);
  Nodes(pool.address).nodes[slot] = node;
  return slot;
}

#endif
