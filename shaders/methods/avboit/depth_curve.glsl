// virtual_slice(z) = n log2(1 + z / a) / log2(1 + b / a): the talk's depth distribution. Halving n merges neighbours exactly
// because a stays: the talk shrinks a with n, which would move every boundary and ask for new coverage.
#ifndef PLUME_AVBOIT_DEPTH_CURVE_GLSL
#define PLUME_AVBOIT_DEPTH_CURVE_GLSL
#include "methods/avboit/volume.h"

// Clamped to where the last slice begins: what lies in it or behind it is there, since a share of it would go to a slice after the last.
float virtual_slice(Volume v, uint slices, float scale, float depth) {
  return clamp(scale * log2(1.0 + max(depth, 0.0) / v.curve_a), 0.0, float(slices) - 1.0);
}

// Depth, m, at which a virtual slice begins.
float depth_of_slice(Volume v, float scale, float slice) { return v.curve_a * (exp2(slice / scale) - 1.0); }
#endif
