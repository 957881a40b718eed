// Phenomenological transparency, sums: beside what coloured weighted blending keeps, how far what lies behind is blurred. A surface at
// depth z that scatters by an angle s (standard deviation), before a background at depth b, blurs it by
//   D = s a k_0 (1 - k_1 / (k_1 + b - z)) / z   radians:
// nothing where they touch, s k_0 in metres where it is far behind, seen from z. Blurs after each other add their variances.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/shade.glsl"
#include "methods/phenomenological/weight.glsl"
#include "methods/parts/weighted/share.glsl"

layout(constant_id = 2) const float kReach = 2.5;   // k_0, m
layout(constant_id = 3) const float kFocus = 0.1;   // k_1, m

layout(location = 0) out vec4 accum;        // rgb: sum C w   a: sum a' w
layout(location = 1) out vec4 modulation;   // rgb: prod(1 - a (1 - t))
layout(location = 2) out vec4 emission;     // rgb
layout(location = 3) out vec4 bent;         // xy: sum of shifts, pixels   z: sum of variances, pixels^2   w: sum of (shift + variance) / z

void main() {
  const Fragment f = shade();
  modulation = vec4(1.0 - f.coverage * (1.0 - f.transmission), 1.0);   // before the coverage is reduced
  const float alpha = gray_coverage(f);
  const Share light = gray_share(f);
  accum = vec4(light.inside, alpha) * weight(f.depth, alpha);
  emission = vec4(light.outside, 0.0);
  const float behind = view.near_m / max(opaque_here(), 1e-9) - f.depth;
  const float pixels_a_radian = 0.5 * float(view.size.y) / view.tan_half_fov.y;
  const float blur = v_transmission.a * f.coverage * kReach * max(behind, 0.0) / (kFocus + max(behind, 0.0)) / f.depth * pixels_a_radian;
  const float variance = min(blur * blur, 4096.0);   // half floats sum a few of them
  bent = vec4(0.0, 0.0, variance, variance / f.depth);
}
