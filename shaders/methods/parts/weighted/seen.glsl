// How much of a fragment weighted blending lets be seen: its share of the fraction, w (1 - T) / sum a w, for methods that know no
// other transmittance. No more than all of it; what shines without covering is not in the fraction and is seen whole.
#ifndef PLUME_WEIGHTED_SEEN_GLSL
#define PLUME_WEIGHTED_SEEN_GLSL

// `sum` is sum a w, `covers` 1 - T, `inside` how much of it rides in the fraction. Where the sum overflowed nothing is known.
float seen_share(float weight, float sum, float covers, float inside) {
  const float share = sum > 0.0 ? min(weight * covers / sum, 1.0) : 1.0;
  return mix(1.0, share, inside);
}

#endif
