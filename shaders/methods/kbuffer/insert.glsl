// k-buffer in one pass, each fragment in turn: it takes a free node, or the place of the farthest if it is nearer. Whichever of the two
// has no place goes to the tail, so that the nodes end as the k nearest whatever the order.
#ifndef PLUME_KBUFFER_INSERT_GLSL
#define PLUME_KBUFFER_INSERT_GLSL
#include "methods/parts/pixel_nodes/farthest.glsl"
#include "methods/kbuffer/tail_targets.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

bool g_evicted = false;
vec3 g_evicted_light, g_evicted_through;

void take_turn(uint pixel, uint before, Fragment f) {
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  Vectors lights = Vectors(arrays.light);
  const uint pixels = view.size.x * view.size.y;
  const uvec2 key = node_key(f.depth, f.id);
  const vec3 light = f.color + f.emission, through = transmittance(f);
  uint place = before * pixels + pixel;
  if (before >= kNodes) {
    const Farthest nodes = farthest_nodes(kNodes, pixel, pixels);
    place = nodes.last_at;
    g_evicted = true;
    if (!in_front(key, nodes.last)) {
      g_evicted_light = light;
      g_evicted_through = through;
      return;
    }
    g_evicted_light = lights.at[place];
    g_evicted_through = throughs.at[place];
  }
  keys.at[place] = key;
  lights.at[place] = light;
  throughs.at[place] = through;
}

void write_evicted() {
  if (!g_evicted) discard;
  write_tail(g_evicted_light, g_evicted_through);
}

#endif
