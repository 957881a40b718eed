// The probe of multi-layer alpha blending: the product of the nodes in front. It is what a light that came last would be given: behind
// where the last node begins, all that is merged in it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(constant_id = 0) const uint kNodes = 8u;
layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };

#include "methods/parts/pixel_nodes/nodes.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  Keys keys = Keys(arrays.keys);
  Vectors throughs = Vectors(arrays.through);
  const uint pixels = view.size.x * view.size.y, place = pixel.y * view.size.x + pixel.x, count = min(turns[place], kNodes);
  vec3 t = vec3(1.0);
  for (uint i = 0u; i < count; ++i)
    if (key_depth(keys.at[i * pixels + place]) < depth) t *= throughs.at[i * pixels + place];
  return t;
}
