// Adaptive transparency that merges the furthest, first pass: the visibility function. A fragment adds a step; of k + 1 steps the two
// farthest become one, at the depth of the nearer,
//   V(z) = prod_{z_i < z} t_i,   t = t_nearer t_farther.
// A node keeps its own step and not yet the product so far: nodes that lie in no order need no moving and no division.
#ifndef PLUME_AOIT_INSERT_GLSL
#define PLUME_AOIT_INSERT_GLSL
#include "methods/parts/pixel_nodes/farthest.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

// What covers nothing is no step.
bool dims(Fragment f) { return transmittance(f) != vec3(1.0); }

void take_turn(uint pixel, uint before, Fragment f) {
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  const uint pixels = view.size.x * view.size.y;
  uvec2 key = node_key(f.depth, f.id);
  vec3 through = transmittance(f);
  uint place = before * pixels + pixel;
  if (before >= kNodes) {
    const Farthest nodes = farthest_nodes(kNodes, pixel, pixels);
    place = nodes.last_at;
    if (in_front(key, nodes.last_but_one)) {   // the two nodes become one; the fragment has the free place
      throughs.at[nodes.last_but_one_at] *= throughs.at[place];
    } else {
      through *= throughs.at[place];
      if (in_front(nodes.last, key)) key = nodes.last;
    }
  }
  keys.at[place] = key;
  throughs.at[place] = through;
}

#endif
