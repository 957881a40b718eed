// Phenomenological transparency, refraction: what haze bends is looked up elsewhere in the background.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/haze.glsl"

layout(location = 0) out vec4 bent;   // as in draw.frag

void main() {
  const vec2 shift = haze_shift();
  bent = vec4(shift, 0.0, length(shift) / v_uv_depth.z);
}
