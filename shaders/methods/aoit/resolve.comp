// Adaptive transparency that merges the furthest, composite:  image = sum_i L_i V(z_i) + background V(infinity).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/aoit/visibility.glsl"
#include "methods/parts/pixel_nodes/overflow.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };
layout(binding = 10) uniform sampler2D light;
layout(binding = 13) uniform sampler2D opaque_color;
layout(binding = 14, rgba16f) writeonly uniform image2D result;
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const ivec2 at = ivec2(gl_GlobalInvocationID.xy);
  const bool inside = all(lessThan(uvec2(at), size));
  const uint pixels = size.x * size.y, pixel = uint(at.y) * size.x + uint(at.x);
  const uint fragments = inside ? turns[pixel] : 0u;
  count_overflow(fragments - min(fragments, kNodes));
  if (!inside) return;
  const vec3 through = visibility(kNoKey, fragments, pixel, pixels);
  imageStore(result, at, vec4(texelFetch(light, at, 0).rgb + texelFetch(opaque_color, at, 0).rgb * through, 1.0));
}
