// The background: a gradient with a sun disc, or one colour.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(location = 0) in vec2 v_ndc;
layout(location = 0) out vec4 color;

void main() {
  const vec3 ray = normalize(view.forward + view.right * (v_ndc.x * view.tan_half_fov.x) - view.up * (v_ndc.y * view.tan_half_fov.y));
  const float rise = max(ray.y, 0.0);
  vec3 sky = mix(view.horizon, view.zenith, 1.0 - exp(-3.5 * rise));
  const float toward = max(dot(ray, view.sun_direction), 0.0);
  sky += view.sun_color * (0.08 * pow(toward, 24.0) + 2.0 * smoothstep(0.9995, 0.9998, toward));
  color = vec4(view.sky != 0u ? sky : view.horizon, 1.0);
}
