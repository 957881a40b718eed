// Multi-layer alpha blending, insertion: a fragment joins the pixel's nodes; of k + 1 nodes the two farthest become one,
//   L = L_front + t_front L_behind,   t = t_front t_behind,   depth = that of the front one.
#ifndef PLUME_MLAB_INSERT_GLSL
#define PLUME_MLAB_INSERT_GLSL
#include "methods/parts/pixel_nodes/farthest.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

void take_turn(uint pixel, uint before, Fragment f) {
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  Vectors lights = Vectors(arrays.light);
  const uint pixels = view.size.x * view.size.y;
  uvec2 key = node_key(f.depth, f.id);
  vec3 light = f.color + f.emission, through = transmittance(f);
  uint place = before * pixels + pixel;
  if (before >= kNodes) {
    const Farthest nodes = farthest_nodes(kNodes, pixel, pixels);
    place = nodes.last_at;
    const vec3 last_light = lights.at[place], last_through = throughs.at[place];
    if (in_front(key, nodes.last_but_one)) {   // the two nodes become one; the fragment has the free place
      const vec3 front_through = throughs.at[nodes.last_but_one_at];
      lights.at[nodes.last_but_one_at] += front_through * last_light;
      throughs.at[nodes.last_but_one_at] = front_through * last_through;
    } else if (in_front(key, nodes.last)) {
      light += through * last_light;
      through *= last_through;
    } else {
      key = nodes.last;
      light = last_light + last_through * light;
      through *= last_through;
    }
  }
  keys.at[place] = key;
  lights.at[place] = light;
  throughs.at[place] = through;
}

#endif
