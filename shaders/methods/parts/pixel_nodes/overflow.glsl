// Counts, in a compute shader of 8 x 8 pixels, what did not get a node of its own. Every invocation of the group must call it.
#ifndef PLUME_PIXEL_NODES_OVERFLOW_GLSL
#define PLUME_PIXEL_NODES_OVERFLOW_GLSL
#include "methods/parts/pixel_nodes/pixel_nodes.h"

layout(scalar, binding = 15) buffer Overflow { NodeOverflow overflow; };
shared uint s_fragments, s_pixels;

void count_overflow(uint fragments) {
  if (gl_LocalInvocationIndex == 0u) s_fragments = s_pixels = 0u;
  barrier();
  if (fragments > 0u) {
    atomicAdd(s_fragments, fragments);
    atomicAdd(s_pixels, 1u);
  }
  barrier();
  if (gl_LocalInvocationIndex == 0u && s_fragments > 0u) {
    atomicAdd(overflow.fragments, s_fragments);
    atomicAdd(overflow.pixels, s_pixels);
  }
}

#endif
