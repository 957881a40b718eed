// WBOIT's sums, with its own place for the divisor.
#ifndef PLUME_WBOIT_SUMS_GLSL
#define PLUME_WBOIT_SUMS_GLSL

layout(constant_id = 2) const uint kDivisor = 1u;

#include "methods/parts/weighted/sums.glsl"

#endif
