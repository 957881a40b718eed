// AVBOIT's transmittance at a depth: the integral, filtered linearly in all three directions, read `bias` slices in front of the
// surface so that it does not occlude itself.
#ifndef PLUME_AVBOIT_TRANSMITTANCE_GLSL
#define PLUME_AVBOIT_TRANSMITTANCE_GLSL
#include "methods/avboit/curve.glsl"
float transmittance_at(Volume v, sampler3D integral, vec2 pixel, float depth) {
  // Texel s + 1 holds T behind slice s; in front of the first one lies texel 0, which is 1.
  const float slice = slice_of(v, depth) - v.bias + 1.0;
  return textureLod(integral, vec3(pixel / (vec2(v.cells) * float(v.divisor)), (slice + 0.5) / float(v.slices + 1u)), 0.0).r;
}
#endif
