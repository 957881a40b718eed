// Sums that outgrew their format: infinite, or, on devices that round half floats towards zero, stuck at the greatest of them.
#ifndef PLUME_WEIGHTED_OVERFLOW_GLSL
#define PLUME_WEIGHTED_OVERFLOW_GLSL

bvec4 overflowed(vec4 sums, bool full_floats) { return greaterThanEqual(sums, vec4(full_floats ? 3.4e38 : 65503.0)); }

#endif
