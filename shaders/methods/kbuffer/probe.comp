// k-buffer's probe: the product of the nodes in front; behind the last of them, with a tail, what the tail's own light is given.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(constant_id = 0) const uint kNodes = 8u;
layout(binding = 11) uniform sampler2D tail_through;
layout(binding = 12) uniform sampler2D tail_alpha;

#include "methods/parts/pixel_nodes/nodes.glsl"
#include "methods/kbuffer/tail.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  const uint pixels = view.size.x * view.size.y, place = pixel.y * view.size.x + pixel.x;
  vec3 t = vec3(1.0);
  uint in_front = 0u;
  for (uint i = 0u; i < kNodes; ++i) {
    const uvec2 key = keys.at[i * pixels + place];
    if (key == kNoKey || key_depth(key) >= depth) continue;
    t *= throughs.at[i * pixels + place];
    ++in_front;
  }
  if (in_front < kNodes) return t;
  return t * tail_share(texelFetch(tail_through, ivec2(pixel), 0).rgb, texelFetch(tail_alpha, ivec2(pixel), 0).rgb);
}
