// What light is left behind smoke and near fires. An extinction volume seen from the light (shaders/effects/light_splat.comp,
// light_integrate.comp) holds the optical depth tau between the sun and any point, a second one that between the zenith and the point.
//   directly from the light:        exp(-tau)                                   (Beer and Lambert)
//   scattered or not:               1 / (1 + 3/4 (1 - g) tau)                   (two-stream diffusion, scattering without loss)
// The difference is light that was scattered on the way: mostly forwards, so it counts as from the same side, times the albedo.
// A fire is a ball of radiance: irradiance / pi at distance d is P / (d^2 + R^2), the inverse square far away and its own radiance in it.
// Limits: smoke is gray for shadows; puffs are spread over cells (see light_grid.comp); fires shine through solids, and on solids through
// smoke; smoke that is asleep casts nothing.
#ifndef PLUME_EFFECTS_LIGHT_VOLUME_GLSL
#define PLUME_EFFECTS_LIGHT_VOLUME_GLSL
#include "effects/light_body.glsl"

layout(scalar, binding = 20) readonly buffer Grids { LightGrid grids[]; };
layout(binding = 21) uniform sampler3D sun_volume;
layout(binding = 22) uniform sampler3D sky_volume;
layout(scalar, binding = 23) readonly buffer Fires {
  uint fire_count;
  FireLight fires[];
};

const float kForward = 0.6;   // mean cosine of scattering: smoke scatters mostly forwards
const float kDiffusion = 0.75 * (1.0 - kForward);

float direct_share(float tau) { return exp(-tau); }
float total_share(float tau) { return 1.0 / (1.0 + kDiffusion * tau); }
float scattered_share(float tau) { return max(total_share(tau) - direct_share(tau), 0.0); }

// Texels are at the middle of cells in s and t, at their front face in l.
vec3 volume_uv(LightGrid grid, vec3 world) { return (in_cells(grid, world) + vec3(0.0, 0.0, 0.5)) / float(grid.cells); }

float sun_depth(vec3 world) { return textureLod(sun_volume, volume_uv(grids[0], world), 0.0).r; }
float sky_depth(vec3 world) { return textureLod(sky_volume, volume_uv(grids[1], world), 0.0).r; }

// Irradiance / pi on a surface that faces the fire.
vec3 fire_light(FireLight fire, vec3 world, out vec3 towards) {
  const vec3 arm = fire.position - world;
  const float squared = dot(arm, arm);
  towards = arm * inversesqrt(max(squared, 1e-8));
  return fire.power / (squared + fire.radius_squared);
}

#endif
