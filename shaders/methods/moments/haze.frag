// Moments, distortion: every haze fragment's shift in any order, weighted by the transmittance in front of it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"
#include "methods/moments/transmittance.glsl"

layout(location = 0) out vec4 distortion;

void main() {
  const vec2 shift = haze_shift();
  if (shift == vec2(0.0)) discard;
  bool unsure;
  const vec3 t = transmittance_at(ivec2(gl_FragCoord.xy), v_uv_depth.z, unsure);
  distortion = haze_sample(shift, dot(t, vec3(1.0 / 3.0)));
}
