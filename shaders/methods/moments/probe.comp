// Moments' probe: the transmittance as the draw reads it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/moments/transmittance.glsl"
#include "probe/probe.glsl"

vec3 probe_transmittance(uvec2 pixel, float depth) {
  bool unsure;
  return transmittance_at(ivec2(pixel), depth, unsure);
}
