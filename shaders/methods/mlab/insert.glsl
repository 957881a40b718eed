// Multi-layer alpha blending, insertion: a fragment joins the pixel's nodes; of k + 1 nodes the two farthest become one,
//   L = L_front + t_front L_behind,   t = t_front t_behind,   depth = that of the front one.
#ifndef PLUME_MLAB_INSERT_GLSL
#define PLUME_MLAB_INSERT_GLSL
#include "methods/pixel_nodes/farthest.glsl"

layout(constant_id = 0) const uint kNodes = 8u;

void take_turn(uint pixel, uint before, Fragment f) {
  const uint pixels = view.size.x * view.size.y;
  uvec2 key = node_key(f.depth, f.id);
  vec3 light = f.color + f.emission, through = transmittance(f);
  uint place = before * pixels + pixel;
  if (before >= kNodes) {
    const Farthest nodes = farthest_nodes(kNodes, pixel, pixels);
    place = nodes.last_at;
    const vec3 last_light = Vectors(arrays.light).at[place], last_through = Vectors(arrays.through).at[place];
    if (in_front(key, nodes.last_but_one)) {   // the two nodes become one; the fragment has the free place
      const vec3 front_through = Vectors(arrays.through).at[nodes.last_but_one_at];
      Vectors(arrays.light).at[nodes.last_but_one_at] += front_through * last_light;
      Vectors(arrays.through).at[nodes.last_but_one_at] = front_through * last_through;
    } else if (in_front(key, nodes.last)) {
      light += through * last_light;
      through *= last_through;
    } else {
      key = nodes.last;
      light = last_light + last_through * light;
      through *= last_through;
    }
  }
  Keys(arrays.keys).at[place] = key;
  Vectors(arrays.light).at[place] = light;
  Vectors(arrays.through).at[place] = through;
}

#endif
