// WBOIT, distortion: every haze fragment's shift by the share of the fraction that an opaque white fragment would have there.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"
#include "methods/wboit/weight.glsl"
#include "methods/wboit/sums.glsl"
#include "methods/parts/weighted/seen.glsl"

layout(location = 0) out vec4 distortion;

void main() {
  const vec2 shift = haze_shift();
  if (shift == vec2(0.0)) discard;
  const Sums s = sums_at(ivec2(gl_FragCoord.xy));
  distortion = haze_sample(shift, seen_share(weight(v_uv_depth.z, 1.0, vec3(1.0)), s.accum.a, 1.0 - s.through.r, 1.0));
}
