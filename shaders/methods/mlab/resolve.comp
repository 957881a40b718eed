// Multi-layer alpha blending, composite: the nodes front to back,  image = sum_i L_i prod_{j<i} t_j + background prod_i t_i.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/pixel_nodes/nodes.glsl"
#include "methods/parts/pixel_nodes/overflow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kNodes = 8u;
layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };
layout(binding = 13) uniform sampler2D opaque_color;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  const bool inside = all(lessThan(uvec2(at), size));
  const uint pixels = size.x * size.y, pixel = uint(at.y) * size.x + uint(at.x);
  const uint fragments = inside ? turns[pixel] : 0u, count = min(fragments, kNodes);
  count_overflow(fragments - count);
  if (!inside) return;
  Vectors throughs = Vectors(arrays.through);
  Vectors lights = Vectors(arrays.light);
  vec3 light = vec3(0.0), through = vec3(1.0);
  uvec2 key = uvec2(0u);
  for (uint i = 0u; i < count; ++i) {
    uint node;
    key = key_after(nearest_from(key, count, pixel, pixels, node));
    light += lights.at[node * pixels + pixel] * through;
    through *= throughs.at[node * pixels + pixel];
  }
  imageStore(result, at, vec4(light + texelFetch(opaque_color, at, 0).rgb * through, 1.0));
}
