// Reading the visibility function: nodes lie front to back, each with the transmittance behind it.
#ifndef PLUME_AOIT_VISIBILITY_GLSL
#define PLUME_AOIT_VISIBILITY_GLSL
#include "methods/parts/pixel_nodes/nodes.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

// In front of what has this key, after `fragments` had their turn.
vec3 visibility(uvec2 key, uint fragments, uint pixel, uint pixels) {
  Keys keys = Keys(arrays.keys);
  uint low = 0u, high = min(fragments, kNodes);   // how many nodes lie in front is in between
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (in_front(keys.at[middle * pixels + pixel], key)) low = middle + 1u;
    else high = middle;
  }
  return low == 0u ? vec3(1.0) : Vectors(arrays.through).at[(low - 1u) * pixels + pixel];
}

#endif
