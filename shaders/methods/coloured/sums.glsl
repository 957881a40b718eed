// The sums of coloured weighted blending: at one resolution.
#ifndef PLUME_COLOURED_SUMS_GLSL
#define PLUME_COLOURED_SUMS_GLSL

const uint kDivisor = 1u;

#include "methods/parts/weighted/sums.glsl"

#endif
