// Adaptive transparency that merges the furthest, between the passes: a pixel's steps are sorted front to back, and each becomes the
// product of those up to it, so that the second pass finds the visibility by bisection.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/pixel_nodes/nodes.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kNodes = 8u;
layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };
layout(push_constant) uniform Push { uvec2 size; };

void main() {
  const uvec2 at = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(at, size))) return;
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  const uint pixels = size.x * size.y, pixel = at.y * size.x + at.x, count = min(turns[pixel], kNodes);
  uvec2 sorted[kNodes];
  vec3 through[kNodes];
  for (uint i = 0u; i < count; ++i) {
    const uvec2 key = keys.at[i * pixels + pixel];
    const vec3 step = throughs.at[i * pixels + pixel];
    uint place = i;
    for (; place > 0u && in_front(key, sorted[place - 1u]); --place) {
      sorted[place] = sorted[place - 1u];
      through[place] = through[place - 1u];
    }
    sorted[place] = key;
    through[place] = step;
  }
  vec3 product = vec3(1.0);
  for (uint i = 0u; i < count; ++i) {
    product *= through[i];
    keys.at[i * pixels + pixel] = sorted[i];
    throughs.at[i * pixels + pixel] = product;
  }
}
