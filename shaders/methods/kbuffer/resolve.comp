// k-buffer, composite: the nodes front to back, then the tail, then the background,
//   image = sum_{i<k} L_i prod_{j<i} t_j  +  prod_{i<k} t_i (tail + background prod_tail t).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/pixel_nodes/nodes.glsl"
#include "methods/parts/pixel_nodes/overflow.glsl"
#include "methods/kbuffer/tail.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kNodes = 8u;
layout(constant_id = 1) const uint kInOrder = 0u;   // the nodes lie front to back
layout(binding = 10) uniform sampler2D tail_light;
layout(binding = 11) uniform sampler2D tail_through;
layout(binding = 12) uniform sampler2D tail_alpha;
layout(binding = 13) uniform sampler2D opaque_color;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  const bool inside = all(lessThan(uvec2(at), size));
  const vec4 tail = inside ? texelFetch(tail_light, at, 0) : vec4(0.0);
  count_overflow(uint(tail.a));
  if (!inside) return;
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  Vectors lights = Vectors(arrays.light);
  const uint pixels = size.x * size.y, pixel = uint(at.y) * size.x + uint(at.x);
  vec3 light = vec3(0.0), through = vec3(1.0);
  uvec2 key = uvec2(0u);
  for (uint i = 0u; i < kNodes; ++i) {
    uint node = i;
    if (kInOrder != 0u) key = keys.at[i * pixels + pixel];
    else key = nearest_from(key, kNodes, pixel, pixels, node);
    if (key == kNoKey) break;
    light += lights.at[node * pixels + pixel] * through;
    through *= throughs.at[node * pixels + pixel];
    key = key_after(key);
  }
  const vec3 passed = texelFetch(tail_through, at, 0).rgb;
  light += through * tail.rgb * tail_share(passed, texelFetch(tail_alpha, at, 0).rgb);
  through *= passed;
  imageStore(result, at, vec4(light + texelFetch(opaque_color, at, 0).rgb * through, 1.0));
}
