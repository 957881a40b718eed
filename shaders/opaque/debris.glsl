// Opaque particles in the light of lighting.glsl, seen from both sides.
#ifndef PLUME_OPAQUE_DEBRIS_GLSL
#define PLUME_OPAQUE_DEBRIS_GLSL
#include "opaque/lighting.glsl"

layout(location = 0) in vec3 v_world;
layout(location = 1) flat in vec3 v_normal;
layout(location = 2) flat in vec4 v_albedo;   // a: 0 = not lit
layout(location = 3) flat in vec3 v_emission;
layout(location = 0) out vec4 color;

void main() {
  const vec3 normal = dot(v_normal, view.camera - v_world) < 0.0 ? -v_normal : v_normal;
  const vec3 light = v_albedo.a > 0.0 ? light_on(v_world, normal, 0.01) : vec3(1.0);
  color = vec4(v_albedo.rgb * light + v_emission, 1.0);
}

#endif
