// What moments are moments of: the functions of warped depth whose means, weighted by absorbance, are kept.
//   power moments:          w^k, k = 1 .. 2 kNodes
//   trigonometric moments:  cos k p, sin k p, k = 1 .. kNodes, with a phase p that leaves a zone of the circle free between the
//                           farthest and the nearest depth.
// Muenstermann, Krumpen, Klein and Peters, "Moment-Based Order-Independent Transparency", I3D 2018.
#ifndef PLUME_MOMENTS_BASIS_GLSL
#define PLUME_MOMENTS_BASIS_GLSL
#include "methods/moments/depth_warp.h"

layout(constant_id = 0) const uint kKind = 0u;   // power4, power6, power8, trig2, trig3, trig4
const bool kPower = kKind < 3u;
const uint kNodes = 2u + kKind % 3u;             // places of the reconstruction beside the one asked for
const bool kHigh = kNodes > 2u;                  // there are more than four numbers beside b0

const float kPi = 3.14159265358979;
const float kWrappingZone = 0.1 * kPi;           // published
const float kMostAbsorbance = 10.0;              // published: opaque fragments are exp(-10)

vec3 absorbance(vec3 transmittance) { return -log(max(transmittance, vec3(exp(-kMostAbsorbance)))); }

// Beyond the bounds there may be depths that are asked about, as far as the circle has room for them.
float warped(DepthWarp warp, float depth) { return clamp(log2(depth) * warp.scale + warp.offset, -1.05, 1.05); }

float phase_of(float w) { return (w + 1.0) * (kPi - 0.5 * kWrappingZone); }

vec2 turn(vec2 a, vec2 b) { return vec2(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x); }   // product of complex numbers

// The first four functions and the next four, of which kNodes = 3 needs two.
void basis(float w, out vec4 low, out vec4 high) {
  if (kPower) {
    const float square = w * w;
    low = vec4(w, square, square * w, square * square);
    high = low * low.w;
  } else {
    const float p = phase_of(w);
    const vec2 once = vec2(cos(p), sin(p)), twice = turn(once, once);
    low = vec4(once, twice);
    high = vec4(turn(twice, once), turn(twice, twice));
  }
}

#endif
