// AVBOIT, distortion: every haze fragment's shift in any order, weighted by the transmittance T(z) in front of it.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"
#include "methods/avboit/transmittance.glsl"

layout(location = 0) out vec4 distortion;

void main() {
  const vec2 shift = haze_shift();
  if (shift == vec2(0.0)) discard;
  bool estimated;
  const vec3 t = transmittance_at(gl_FragCoord.xy, slice_at(v_uv_depth.z), vec3(0.0)).transmittance *
                 layers_in_front(uvec2(gl_FragCoord.xy), v_uv_depth.z, v_layers_id.z, vec3(0.0), estimated);
  distortion = haze_sample(shift, dot(t, vec3(1.0 / 3.0)));
}
