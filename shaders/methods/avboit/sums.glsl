// AVBOIT's sums of a pixel as integers, which are the same bits whatever the order of what is added: kSumSteps a unit. Products are sums
// of logarithms.
#ifndef PLUME_AVBOIT_SUMS_GLSL
#define PLUME_AVBOIT_SUMS_GLSL
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/avboit/sums.h"
#include "surface/inside.glsl"

layout(buffer_reference, scalar, buffer_reference_align = 8) buffer Sums { int64_t at[]; };   // [pixel][kSums]
layout(scalar, binding = 16) readonly buffer SumsAddress { uvec2 sums_address; };

// Pixels at half the resolution follow the others.
uint first_sum(uvec2 at, uvec2 size, uint scale) {
  const uint pixel = index_inside(at, (size + scale - 1u) / scale);
  return (pixel + (scale > 1u ? size.x * size.y : 0u)) * kSums;
}

float logarithm(float through) { return through > 0.0 ? -log(through) : kNothingThrough; }

void add_sum(uint sum, float value) { atomicAdd(Sums(sums_address).at[sum], int64_t(round(value * kSumSteps))); }
void add_sums(uint first, vec3 values) {
  for (uint c = 0u; c < 3u; ++c) add_sum(first + c, values[c]);
}

float sum(uint index) { return float(Sums(sums_address).at[index]) / kSumSteps; }
vec3 sums(uint first) { return vec3(sum(first), sum(first + 1u), sum(first + 2u)); }

#endif
