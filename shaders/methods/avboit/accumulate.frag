// AVBOIT, draw: every fragment in any order, weighted by the transmittance T(z) in front of it.
//   light:   rgb sum (C a + E) T     a: prod(1 - a) of scalar sources
//   norm:    sum a T                 what the fraction in resolve divides by; a sum for each channel behind RGB sources
//   through: rgb prod t              of RGB sources
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/avboit/transmittance.glsl"

layout(constant_id = 3) const uint kRgbSource = 0u;   // what is drawn passes some colours better than others
layout(constant_id = 4) const uint kTilted = 0u;      // it spans slices

layout(location = 7) flat in float v_slice;

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 norm;
layout(location = 2) out vec4 through;

void main() {
  const Fragment f = shade();
  const vec3 passed = kRgbSource != 0u ? transmittance(f) : vec3(1.0 - gray_coverage(f));
  const vec3 own = -log(max(passed, vec3(kLeastTransmittance)));
  const vec3 t = transmittance_at(gl_FragCoord.xy, kTilted != 0u ? slice_at(f.depth) : v_slice, own);
  light = vec4((f.color + f.emission) * t, kRgbSource != 0u ? 1.0 : passed.r);
  norm = vec4((1.0 - passed) * t, 0.0);
  through = vec4(passed, 1.0);
}
