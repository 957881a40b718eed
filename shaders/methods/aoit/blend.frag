// Adaptive transparency that merges the furthest, second pass: every fragment is drawn again and added with its visibility,
//   sum_i L_i V(z_i).
// Emission without coverage is a fragment like any other here.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/parts/pixel_nodes/seen.glsl"
#include "methods/aoit/visibility.glsl"

layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };
layout(location = 0) out vec4 light;

void main() {
  Fragment f;
  if (!shade_seen(f)) discard;
  const uint pixel = pixel_index(view.size);
  const vec3 seen = visibility(node_key(f.depth, f.id), turns[pixel], pixel, view.size.x * view.size.y);
  light = vec4((f.color + f.emission) * seen, 0.0);
}
