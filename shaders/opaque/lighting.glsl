// The light on opaque things: the sun, with exact shadows of the analytic bodies, and the sky. Whoever includes this says what else there
// is on the way of light: without_effects.glsl or with_effects.glsl.
#ifndef PLUME_OPAQUE_LIGHTING_GLSL
#define PLUME_OPAQUE_LIGHTING_GLSL
#include "shared/solid.h"
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Solids { SolidData solids[]; };

struct Reached {
  float sun;    // share of it that reaches a place
  float sky;
  vec3 added;   // irradiance / pi from other lights on a surface there
};
Reached reached(vec3 world, vec3 normal);

bool hits_box(SolidData s, vec3 origin, vec3 direction) {
  const vec3 local = origin - s.position;
  const vec3 o = vec3(local.x * s.yaw_cos - local.z * s.yaw_sin, local.y, local.z * s.yaw_cos + local.x * s.yaw_sin);
  const vec3 d = vec3(direction.x * s.yaw_cos - direction.z * s.yaw_sin, direction.y, direction.z * s.yaw_cos + direction.x * s.yaw_sin);
  const vec3 a = (-s.half_size - o) / d, b = (s.half_size - o) / d;
  const vec3 enter = min(a, b), leave = max(a, b);
  return max(max(enter.x, enter.y), max(enter.z, 0.0)) < min(leave.x, min(leave.y, leave.z));
}

// Least distance between the ray and the capsule's core, against its radius.
bool hits_capsule(SolidData s, vec3 origin, vec3 direction) {
  const vec3 core = s.end - s.position, gap = origin - s.position;
  const float cc = max(dot(core, core), 1e-12), cd = dot(core, direction), cg = dot(core, gap), dg = dot(direction, gap);
  const float denominator = max(cc - cd * cd, 1e-12);
  float along = clamp((cg - cd * dg) / denominator, 0.0, 1.0);
  float t = along * cd - dg;
  if (t < 0.0) {
    t = 0.0;
    along = clamp(cg / cc, 0.0, 1.0);
  }
  const vec3 between = gap + direction * t - core * along;
  return dot(between, between) < s.radius * s.radius;
}

float sunlight(vec3 origin) {
  for (uint i = 0u; i < view.solid_count; ++i) {
    const SolidData s = solids[i];
    if (s.kind == kSolidPlane) continue;
    const bool hit = s.kind == kSolidBox ? hits_box(s, origin, view.sun_direction) : hits_capsule(s, origin, view.sun_direction);
    if (hit) return 0.0;
  }
  return 1.0;
}

// What a white surface sends back. Its shadow is looked up `offset_m` above it.
vec3 light_on(vec3 place, vec3 normal, float offset_m) {
  const float facing = max(dot(normal, view.sun_direction), 0.0);
  const Reached light = reached(place, normal);
  const vec3 sun = light.sun * view.sun_color * facing * (facing > 0.0 ? sunlight(place + normal * offset_m) : 0.0);
  const vec3 sky = mix(view.horizon * 0.45, view.zenith * 0.6 + view.horizon * 0.35, normal.y * 0.5 + 0.5);
  const float contact = 1.0 - 0.45 * exp(-3.0 * max(place.y, 0.0)) * (1.0 - abs(normal.y));   // darker where walls meet ground
  return sun + light.sky * sky * contact + light.added;
}

#endif
