// Light on opaque things that smoke takes and fires add.
#ifndef PLUME_OPAQUE_WITH_EFFECTS_GLSL
#define PLUME_OPAQUE_WITH_EFFECTS_GLSL
#include "effects/light_volume.glsl"
#include "opaque/lighting.glsl"

layout(constant_id = 0) const uint kShadowed = 1u;   // something casts

Reached reached(vec3 world, vec3 normal) {
  Reached light = Reached(1.0, 1.0, vec3(0.0));
  if (kShadowed != 0u) {
    light.sun = direct_share(sun_depth(world));
    light.sky = mix(1.0, total_share(sky_depth(world)), 0.25 + 0.25 * normal.y);   // half of it is within 45 degrees of the zenith
  }
  for (uint f = 0u; f < fire_count; ++f) {
    vec3 towards;
    const vec3 arriving = fire_light(fires[f], world, towards);
    light.added += arriving * max(dot(normal, towards), 0.0);
  }
  return light;
}

#endif
