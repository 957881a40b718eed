// Fourier opacity mapping, second pass over the fragments: each weighted by the transmittance in front of it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/absorbance/fragment.glsl"
#include "methods/fourier/transmittance.glsl"
#include "methods/parts/weighted/weighted.glsl"

void main() {
  const Fragment f = shade();
  const vec3 t = transmittance_in_front(gl_FragCoord.xy, f.depth, absorbance(f));
  write_weighted(f, max(t, vec3(kLeastWeight)), t, kChannels == 3u);
}
