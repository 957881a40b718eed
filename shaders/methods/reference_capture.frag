// Exact transparency, first half: every fragment of a pixel joins its linked list (Yang et al., "Real-Time Concurrent Linked
// List Construction on the GPU", EGSR 2010). Nothing is dropped: fragments beyond the capacity are counted, the pool is grown
// by the host, and the frame is drawn again.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "surface/shade.glsl"
#include "methods/reference.h"

layout(early_fragment_tests) in;
layout(scalar, binding = 8) buffer Pool { FragmentPool pool; };
layout(scalar, binding = 9) buffer Heads { uint heads[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Nodes { FragmentNode nodes[]; };

void main() {
  const Fragment f = shade();
  if (f.coverage == 0.0 && f.emission == vec3(0.0)) return;   // changes nothing, exactly
  const uint slot = atomicAdd(pool.count, 1u);
  if (slot >= pool.capacity) return;
  const uvec2 pixel = uvec2(gl_FragCoord.xy);
  const uint next = atomicExchange(heads[pixel.y * view.size.x + pixel.x], slot);
  Nodes(pool.address).nodes[slot] = FragmentNode(f.color + f.emission, f.depth, transmittance(f), f.id, next);
}
