// AVBOIT, draw: every fragment in any order, weighted by the transmittance T(z) in front of it.
//   light:   rgb sum (C a + E) T     a: prod(1 - a) of scalar sources
//   norm:    rgb sum a_c T_c         what the fraction in resolve divides by
//   through: rgb prod t              of RGB sources
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/avboit/transmittance.glsl"

layout(constant_id = 3) const uint kRgbSource = 0u;   // what is drawn passes some colours better than others

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 norm;
layout(location = 2) out vec4 through;

void main() {
  const Fragment f = shade();
  const vec3 passed = transmittance(f);
  const float gray = 1.0 - gray_coverage(f);
  const vec3 alpha = kRgbSource != 0u ? 1.0 - passed : vec3(1.0 - gray);
  const vec3 own_rgb = kRgbSource != 0u ? -log(max(passed, vec3(kLeastTransmittance))) : vec3(0.0);
  const float own = kRgbSource != 0u ? 0.0 : -log(max(gray, kLeastTransmittance));
  const vec3 t = transmittance_at(gl_FragCoord.xy, f.depth, own, own_rgb);
  light = vec4((f.color + f.emission) * t, kRgbSource != 0u ? 1.0 : gray);
  norm = vec4(alpha * t, 0.0);
  through = vec4(passed, 1.0);
}
