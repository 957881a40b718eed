// AVBOIT, draw: every fragment in any order, weighted by the transmittance T(z) in front of it.
//   light:   rgb sum (C a + E) T     a: prod(1 - a) of scalar sources
//   norm:    sum a T                 what the fraction in resolve divides by; a sum for each channel behind RGB sources
//   through: rgb prod t, a: prod(mean t), of RGB sources
// Chromaticity skew (kSkew): optical depth of each channel counts as far as the fragment is seen, mix(gray, rgb, T(z)), so that
// glass in thick smoke does not tint what lies before it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/avboit/colour.h"
#include "methods/avboit/transmittance.glsl"

layout(constant_id = 3) const uint kRgbSource = 0u;   // what is drawn passes some colours better than others
layout(constant_id = 4) const uint kGeneral = 0u;     // it spans slices or passes light where it covers
layout(constant_id = 5) const uint kColour = kFullRgb;

layout(constant_id = 6) const uint kBehindLayers = 0u;

layout(location = 7) flat in vec2 v_slice_own;

layout(location = 0) out vec4 light;
layout(location = 1) out vec4 norm;
layout(location = 2) out vec4 through;

void main() {
  const Fragment f = shade();
  const float gray = 1.0 - gray_coverage(f);
  const vec3 passed = kRgbSource != 0u ? transmittance(f) : vec3(gray);
  const vec3 weighed = kColour == kFullRgb ? passed : vec3(gray);
  const vec3 own = kGeneral != 0u ? -log(max(weighed, vec3(kLeastTransmittance))) : vec3(f.optical_depth);
  vec3 t = transmittance_at(gl_FragCoord.xy, kGeneral != 0u ? slice_at(f.depth) : v_slice_own.x, own * v_slice_own.y);
  if (kBehindLayers != 0u) {
    const vec3 layers_t = layers_in_front(uvec2(gl_FragCoord.xy), f.depth);
    t *= kColour == kFullRgb ? layers_t : vec3(dot(layers_t, vec3(1.0 / 3.0)));
  }
  vec3 seen = f.color + f.emission;
  vec3 tint = passed;
  if (kColour == kSkew || kColour == kFirstEvent) tint = exp(mix(log(max(vec3(gray), kLeastTransmittance)), log(max(passed, kLeastTransmittance)), t));
  if (kColour == kFirstEvent && kRgbSource != 0u) seen *= luma(tint) / max(tint, vec3(1.0 / 256.0));
  light = vec4(seen * t, kRgbSource != 0u ? 1.0 : gray);
  norm = vec4((1.0 - weighed) * t, 0.0);
  through = vec4(tint, gray);
}
