// The probe of methods that capture fragments: the product of those in front.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/parts/fragment_list/sort.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  Nodes list = Nodes(pool.address);
  vec3 t = vec3(1.0);
  for (uint node = heads[pixel.y * view.size.x + pixel.x]; node != kListEnd; node = list.nodes[node].next)
    if (list.nodes[node].depth < depth) t *= list.nodes[node].transmittance;
  return t;
}
