// Adaptive transparency, resolve: a pixel's visibility is built from its list, then
//   image = sum_i L_i V(z_i)  +  background V(infinity).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/adaptive/visibility.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(binding = 10) uniform sampler2D opaque_color;
layout(binding = 11, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, size))) return;
  Nodes list = Nodes(pool.address);
  const uint ray = pixel.y * size.x + pixel.x;
  // On overflow the lists are incomplete and the frame is drawn again.
  const uint head = pool.count > pool.capacity ? kListEnd : sort(list, heads[ray]);
  heads[ray] = head;
  build_visibility(list, head);
  vec3 light = vec3(0.0);
  for (uint node = head; node != kListEnd; node = list.nodes[node].next)
    light += list.nodes[node].light * visibility(list.nodes[node].depth, list.nodes[node].id);
  const vec3 background = texelFetch(opaque_color, ivec2(pixel), 0).rgb;
  imageStore(result, ivec2(pixel), vec4(light + background * total_visibility(), 1.0));
}
