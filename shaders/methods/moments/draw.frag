// Moments, second pass: every fragment weighted by the transmittance that the moments of its pixel tell,
//   image = (sum C a T) (1 - prod(1 - a)) / (sum a T) + background prod(1 - a).
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/moments/transmittance.glsl"
#include "methods/parts/weighted/weighted.glsl"

void main() {
  const Fragment f = shade();
  bool unsure;
  const vec3 t = transmittance_at(ivec2(gl_FragCoord.xy), f.depth, unsure);
  write_weighted(f, t * kWeightScale, t, kRgb != 0u);
  emission.a = unsure ? 1.0 : 0.0;   // counted
}
