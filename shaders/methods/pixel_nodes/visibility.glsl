// The transmittance that a pixel's nodes believe in: a product of steps.
#ifndef PLUME_PIXEL_NODES_VISIBILITY_GLSL
#define PLUME_PIXEL_NODES_VISIBILITY_GLSL
#include "methods/pixel_nodes/nodes.glsl"

// In front of what has this key, after `fragments` had their turn with `nodes` nodes.
vec3 visibility(uvec2 key, uint fragments, uint nodes, uint pixel, uint pixels) {
  vec3 t = vec3(1.0);
  const uint count = min(fragments, nodes);
  for (uint i = 0u; i < count; ++i)
    if (in_front(Keys(arrays.keys).at[i * pixels + pixel], key)) t *= Vectors(arrays.through).at[i * pixels + pixel];
  return t;
}

#endif
