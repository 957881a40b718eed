// What a probed fragment adds to the pixel under weighted blending, relative to its light: what rides in the fraction by its share
// w (1 - T) / sum a w, which may exceed 1, what is summed outside of it whole. Where it has no light: what light of its coverage would add.
#ifndef PLUME_WEIGHTED_CONTRIBUTION_GLSL
#define PLUME_WEIGHTED_CONTRIBUTION_GLSL
#include "methods/parts/weighted/inside.glsl"
#include "probe/probe.glsl"

// The mean channel's coverage, as gray_coverage() has it of a fragment; of a bare light that of an opaque one.
float probed_alpha() { return probed.card == kBareLight ? 1.0 : 1.0 - dot(probed.transmittance, vec3(1.0 / 3.0)); }

vec3 probed_light() { return probed.card == kBareLight ? vec3(1.0) : probed.color + probed.emission; }

// `share` of each channel.
vec3 contribution(vec3 share) {
  if (probed.card == kBareLight) return share;
  const float alpha = probed_alpha(), blocks = probed.coverage > 0.0 ? alpha / probed.coverage : 0.0;
  const vec3 color_inside = share_inside(vec3(blocks)), emission_inside = share_inside(vec3(alpha)), light = probed_light();
  const vec3 inside = probed.color * color_inside + probed.emission * emission_inside;
  return mix((inside * share + light - inside) / light, mix(vec3(1.0), share, emission_inside), lessThanEqual(light, vec3(0.0)));
}

#endif
