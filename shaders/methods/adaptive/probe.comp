// Adaptive transparency's probe: the visibility that the pixel was drawn with, built once more from its list.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/adaptive/visibility.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  build_visibility(Nodes(pool.address), heads[pixel.y * view.size.x + pixel.x]);
  return visibility(depth, 0u);
}
