// The bounded A-buffer's probe: the product of the layers in front. The tail has no depth: what is behind the last layer is told
// what all layers pass.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(constant_id = 3) const uint kNearest = 1u;

#include "methods/abuffer/layers.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  const uint pixels = view.size.x * view.size.y, ray = pixel.y * view.size.x + pixel.x;
  vec3 t = vec3(1.0);
  for (uint k = 0u; k < kLayers; ++k) {
    if (kNearest == 0u && k >= counters[ray]) break;
    const Stored layer = read_layer(k * pixels + ray);
    if (is_free(layer.key)) break;
    if (layer.key.y >> 8 < depth_code(depth)) t *= decode(layer).transmittance;
  }
  return t;
}
