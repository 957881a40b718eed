// The sums that weighted methods share:  image = (sum C a w) (1 - T) / (sum a w) + emission + background T.
//
// Emission rides in the fraction as far as the fragment covers, as the papers' premultiplied colour does; emission with next to no
// coverage would vanish or explode there where sum a w -> 0, so it is summed outside, weighted by `outside`.
#ifndef PLUME_SURFACE_WEIGHTED_GLSL
#define PLUME_SURFACE_WEIGHTED_GLSL

struct WeightedSums {
  vec4 accum;      // rgb: sum C a w, a: sum a w
  vec4 emission;   // rgb
};

WeightedSums weighted(Fragment f, float weight, float outside) {
  const float alpha = gray_coverage(f);
  const float inside = min(alpha * 255.0, 1.0);
  WeightedSums s;
  s.accum = vec4(f.color + f.emission * inside, alpha) * weight;
  s.emission = vec4(f.emission * (1.0 - inside) * outside, 0.0);
  return s;
}

#endif
