// Stochastic transparency, accumulation: every fragment is weighted by the share V of the samples that it is not behind,
//   image = sum C a V [prod-corrected: * (1 - T) / sum a V] + background T
// (Enderton et al., sections 4.2 and 4.3).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/stochastic/plane_depth.glsl"
#include "methods/stochastic/visible.glsl"
#include "methods/weighted/weighted.glsl"

layout(early_fragment_tests) in;

void main() {
  if (!on_card()) discard;
  const Fragment f = shade();
  const vec3 seen = vec3(visible_at(ivec2(gl_FragCoord.xy), plane_depth()));
  write_weighted(f, seen, seen, false);
}
