// Weighted, blended order-independent transparency: w guesses from depth and opacity how much of a fragment is seen,
//   image = (sum C a w) (1 - prod(1 - a)) / (sum a w) + background prod(1 - a).
// Limits: the guess must be tuned to the scene's depths; near-opaque things let what lies behind them through.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/wboit/weight.glsl"
#include "methods/parts/weighted/weighted.glsl"

void main() {
  const Fragment f = shade();
  write_weighted(f, vec3(weight(f.depth, gray_coverage(f), f.color + f.emission)), vec3(1.0), false);
}
