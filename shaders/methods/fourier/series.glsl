// Absorbance over depth as a Fourier series. Jansen and Bavoil, "Fourier Opacity Mapping", I3D 2010, along the rays of the camera, not
// of a light. Fragments of absorbance a_i at x_i, 0..1 along a cell's ray, are kept as
//   c = sum a_i,   p_k = sum a_i cos(2 pi k x_i),   q_k = sum a_i sin(2 pi k x_i),   k = 1..kPairs,
// and what they absorb in front of x is
//   A(x) = c x + sum_k (p_k sin(2 pi k x) + q_k (1 - cos(2 pi k x))) / (pi k).
// The series repeats: places keep away from both ends, so that what comes last does not shade what comes first.
#ifndef PLUME_FOURIER_SERIES_GLSL
#define PLUME_FOURIER_SERIES_GLSL
#include "methods/parts/absorbance/cells.glsl"

layout(constant_id = 6) const uint kPairs = 3u;

const uint kMostPairs = 7u;
const float kPi = 3.14159265;
const float kMargin = 0.1;   // of the period, at each end

float in_period(float place) { return place == kBehind ? 1.0 : mix(kMargin, 1.0 - kMargin, place); }

vec2 turned(vec2 by, vec2 from) { return vec2(by.x * from.x - by.y * from.y, by.x * from.y + by.y * from.x); }
// (cos, sin) of 2 pi x.
vec2 wave(float x) { return vec2(cos(2.0 * kPi * x), sin(2.0 * kPi * x)); }

// The share of a fragment's own absorbance that A(x) holds where it lies: a half, but for the ripple.
float own_share(float x) {
  const vec2 first = wave(x);
  vec2 now = first;
  float sum = x;
  for (uint k = 1u; k <= kPairs; ++k) {
    sum += now.y / (kPi * float(k));
    now = turned(first, now);
  }
  return sum;
}

#endif
