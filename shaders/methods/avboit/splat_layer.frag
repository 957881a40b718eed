// AVBOIT, raster splat: transmittance multiplied into the layer of a slice, (1 - a)^share; one value or one a channel.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/splat_surface.glsl"

layout(constant_id = 3) const uint kRgb = 0u;
layout(location = 7) flat in float v_share;
layout(location = 0) out vec4 through;

void main() {
  if (hidden()) discard;
  const vec3 passed = passed_by(v_ambient.a * cell_density());
  const vec3 t = kRgb != 0u ? passed : vec3(dot(passed, vec3(1.0 / 3.0)));
  through = vec4(pow(max(t, vec3(0.0)), vec3(v_share)), 1.0);
}
