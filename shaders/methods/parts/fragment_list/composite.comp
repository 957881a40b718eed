// The exact composite: each pixel's list is sorted by (depth, card) and composited front to back in 32 bits,
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/fragment_list/sort.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
// The frame will be drawn again when the lists overflowed: sorting incomplete ones would be wasted.
layout(constant_id = 0) const uint kRedrawn = 0u;
layout(binding = 10) uniform sampler2D background;   // may be the result: a pixel is read before it is written
layout(binding = 11, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, size))) return;
  Nodes list = Nodes(pool.address);
  vec3 light = vec3(0.0), through = vec3(1.0);
  const uint ray = pixel.y * size.x + pixel.x;
  uint node = kRedrawn != 0u && pool.count > pool.capacity ? kListEnd : sort(list, heads[ray]);
  heads[ray] = node;   // left front to back, for whoever wants the fragments of a pixel
  for (; node != kListEnd; node = list.nodes[node].next) {
    light += list.nodes[node].light * through;
    through *= list.nodes[node].transmittance;
  }
  imageStore(result, ivec2(pixel), vec4(light + texelFetch(background, ivec2(pixel), 0).rgb * through, 1.0));
}
