// slice(z) = n log2(1 + z/a) / log2(1 + b/a): the talk's depth distribution. Continuous; clamped to the volume.
#ifndef PLUME_AVBOIT_CURVE_GLSL
#define PLUME_AVBOIT_CURVE_GLSL
#include "methods/avboit/volume.h"
float slice_of(Volume v, float depth) {
  const float s = float(v.slices) * log2(1.0 + depth / v.curve_a) / log2(1.0 + v.curve_b / v.curve_a);
  return clamp(s, 0.0, float(v.slices - 1u));
}
#endif
