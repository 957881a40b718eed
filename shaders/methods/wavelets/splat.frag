// Wavelet transparency, first pass over the fragments: their absorbance into the coefficients of their cell.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/parts/absorbance/splat.glsl"
#include "methods/wavelets/haar.glsl"

void main() {
  const Splat s = splat();
  add_step(s.cell, s.place, s.absorbance);
}
