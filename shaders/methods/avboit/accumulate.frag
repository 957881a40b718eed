// AVBOIT, draw: every fragment in any order, weighted by the transmittance in front of it; see surface/weighted.glsl.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "surface/weighted.glsl"
#include "methods/avboit/transmittance.glsl"

layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(binding = 9) uniform sampler3D integral;

layout(location = 0) out vec4 accum;
layout(location = 1) out float optical_depth;
layout(location = 2) out vec4 emission;

void main() {
  const Fragment f = shade();
  const float weight = transmittance_at(volume, integral, gl_FragCoord.xy, f.depth);
  const WeightedSums s = weighted(f, weight, weight);
  accum = s.accum;
  optical_depth = -log(max(1.0 - gray_coverage(f), kLeastTransmittance));
  emission = s.emission;
}
