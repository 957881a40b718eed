// Moments, first pass: b0 = sum a and b_k = sum a f_k(w) of all fragments of a pixel, in any order, by additive blending in 32 bits;
// a is the absorbance -ln(transmittance), f_k the functions of basis.glsl. In RGB each channel has its own.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/moments/basis.glsl"

layout(constant_id = 1) const uint kRgb = 0u;
layout(constant_id = 2) const uint kDivisor = 1u;   // pixels of the picture a fragment, each way
layout(scalar, binding = 8) uniform Warp { DepthWarp warp; };

// Those that a kind does not use come last.
layout(location = 0) out vec4 b0;
layout(location = 1) out vec4 first;
layout(location = 2) out vec4 second;
layout(location = 3) out vec4 third;
layout(location = 4) out vec4 fourth;
layout(location = 5) out vec4 fifth;
layout(location = 6) out vec4 sixth;

void main() {
  const Fragment f = shade();
  if (kDivisor > 1u && f.depth * opaque_here() > view.near_m) discard;   // behind the whole cell
  const vec3 a = absorbance(kRgb != 0u ? transmittance(f) : vec3(1.0 - gray_coverage(f)));
  vec4 low, high;
  basis(warped(warp, f.depth), low, high);
  b0 = vec4(a, 0.0);
  first = low * a.r;
  if (kHigh) {
    second = high * a.r;
    third = low * a.g;
    fourth = high * a.g;
    fifth = low * a.b;
    sixth = high * a.b;
  } else {
    second = low * a.g;
    third = low * a.b;
    fourth = fifth = sixth = vec4(0.0);
  }
}
