// The two farthest of a pixel's nodes: the place to make room in.
#ifndef PLUME_PIXEL_NODES_FARTHEST_GLSL
#define PLUME_PIXEL_NODES_FARTHEST_GLSL
#include "methods/parts/pixel_nodes/nodes.glsl"

struct Farthest {
  uvec2 last, last_but_one;        // keys; that of no node is in front of all
  uint last_at, last_but_one_at;   // in the arrays
};

Farthest farthest_nodes(uint count, uint pixel, uint pixels) {
  Keys keys = Keys(arrays.keys);
  Farthest f = Farthest(uvec2(0u), uvec2(0u), 0u, 0u);
  for (uint i = 0u; i < count; ++i) {
    const uint at = i * pixels + pixel;
    const uvec2 key = keys.at[at];
    if (!in_front(key, f.last)) {
      f.last_but_one = f.last;
      f.last_but_one_at = f.last_at;
      f.last = key;
      f.last_at = at;
    } else if (!in_front(key, f.last_but_one)) {
      f.last_but_one = key;
      f.last_but_one_at = at;
    }
  }
  return f;
}

#endif
