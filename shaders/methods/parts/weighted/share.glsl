// Light rides in the weighted fraction as far as the fragment covers, as the papers' premultiplied colour does. What shines with next to
// no coverage would vanish or explode there, where sum a w -> 0: it is summed outside, as it is.
#ifndef PLUME_WEIGHTED_SHARE_GLSL
#define PLUME_WEIGHTED_SHARE_GLSL
#include "methods/parts/weighted/inside.glsl"

struct Share {
  vec3 inside;    // of the fraction
  vec3 outside;
};

// `alpha` of the fragment; `blocks` is what it would be at full coverage.
Share share_of(Fragment f, vec3 alpha, vec3 blocks) {
  const vec3 color_inside = share_inside(blocks), emission_inside = share_inside(alpha);
  return Share(f.color * color_inside + f.emission * emission_inside, f.color * (1.0 - color_inside) + f.emission * (1.0 - emission_inside));
}

Share gray_share(Fragment f) {
  return share_of(f, vec3(gray_coverage(f)), vec3(1.0 - dot(f.transmission, vec3(1.0 / 3.0))));
}

#endif
