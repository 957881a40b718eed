// The probe of Fourier opacity mapping: what a bare light or a fragment would be drawn with.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };

#include "methods/fourier/transmittance.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  return transmittance_in_front(vec2(pixel) + 0.5, depth, absorbance_of(probed.transmittance));
}
