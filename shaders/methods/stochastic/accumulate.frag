// Stochastic transparency, accumulation: every fragment is weighted by the share V of the samples that it is not behind,
//   image = sum C a V (1 - T) / sum a V + background T        T = prod (1 - a)
// (Enderton et al., I3D 2010, section 3), or without the alpha correction, and so without the fraction,
//   image = sum C a V + background T
// The composite is methods/parts/weighted/resolve.comp.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/stochastic/plane_depth.glsl"
#include "methods/stochastic/visible.glsl"
#include "methods/parts/weighted/weighted.glsl"

layout(early_fragment_tests) in;

void main() {
  const Fragment f = shade();
  const vec3 seen = vec3(visible_at(ivec2(gl_FragCoord.xy), plane_depth()));
  write_weighted(f, seen, seen, false);
}
