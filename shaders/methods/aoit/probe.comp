// AOIT's probe: the visibility function that its fragments are weighed by.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 8) readonly buffer Turns { uint turns[]; };

#include "methods/aoit/visibility.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const uint place = pixel.y * view.size.x + pixel.x;
  return visibility(node_key(depth, 0u), turns[place], place, view.size.x * view.size.y);
}
