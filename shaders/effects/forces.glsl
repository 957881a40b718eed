// What accelerates a particle, as a function of its place, its age and the time since the call: gravity, buoyancy that cools,
// drifting curl noise, a vortex, attractors, a vector field. Every term is bounded wherever the particle is.
#ifndef PLUME_EFFECTS_FORCES_GLSL
#define PLUME_EFFECTS_FORCES_GLSL
#include "effects/noise.glsl"
#include "effects/particle.glsl"
#include "shared/motion_tables.h"

layout(scalar, binding = 10) readonly buffer Attractors { AttractorData attractors[]; };
layout(scalar, binding = 11) readonly buffer FieldCells { vec3 field_cells[]; };

struct Forces {
  vec3 acceleration;   // m/s^2
  vec3 wind;           // m/s: what drag pulls the velocity to
};

// A line vortex along +y through the origin, the fastest at its core's radius, and a pull of constant size towards the axis.
vec3 vortex(EmitterData e, vec3 arm3) {
  precise vec2 arm = arm3.xz;
  precise float distance = sqrt(dot(arm, arm)) + 1e-6;
  precise float reach = distance * e.vortex_inv_radius;
  precise float swirl = e.vortex_strength * reach / (1.0 + reach * reach) * 2.0 / distance;
  precise vec2 result = vec2(-arm.y, arm.x) * swirl - arm * (e.vortex_pull / distance);
  return vec3(result.x, 0.0, result.y);
}

// Plummer's softened point mass, put at the nearest point of the segment: conservative, `strength` at the radius, at most 1.09
// times that, 1/r^2 far away, 0 in the centre.
vec3 attraction(AttractorData a, vec3 place) {
  precise vec3 arm = a.from - place;
  precise float square = dot(a.along, a.along);
  precise float t = square > 0.0 ? clamp(-dot(arm, a.along) / square, 0.0, 1.0) : 0.0;
  arm += a.along * t;
  precise vec3 q = arm * a.inv_radius;
  precise float s = 1.0 + dot(q, q);
  precise vec3 result = arm * (a.scale / (s * sqrt(s)));
  return result;
}

// Trilinear between the centres of cells, constant in the outer half cell, nothing outside the grid.
vec3 field_at(EmitterData e, vec3 place) {
  precise vec3 at = (place - e.field_low) * e.field_inv_cell;
  const vec3 size = vec3(e.field_size);
  const bool inside = all(greaterThanEqual(at, vec3(0.0))) && all(lessThan(at, size));   // never where there is no field
  if (!inside) return vec3(0.0);
  at = clamp(at - 0.5, vec3(0.0), size - 1.0);
  precise vec3 base = min(floor(at), max(size - 2.0, vec3(0.0)));
  precise vec3 f = at - base;
  const uvec3 low = uvec3(base), high = min(low + 1u, e.field_size - 1u);
  precise vec3 sum = vec3(0.0);
  for (uint corner = 0u; corner < 8u; ++corner) {
    const bvec3 upper = bvec3((corner & 1u) != 0u, (corner & 2u) != 0u, (corner & 4u) != 0u);
    const uvec3 cell = mix(low, high, upper);
    precise vec3 w = mix(1.0 - f, f, upper);
    sum += field_cells[e.field_first + (cell.z * e.field_size.y + cell.y) * e.field_size.x + cell.x] * (w.x * w.y * w.z);
  }
  precise vec3 result = sum * e.field_strength;
  return result;
}

Forces forces_on(EmitterData e, vec3 origin, Motion m, uint age, uint local_tick) {
  precise vec3 acceleration = e.gravity;
  acceleration.y += e.buoyancy * exp(-float(age) * kTick * e.inv_cooling);
  precise vec3 wind = e.wind;
  precise vec3 arm = m.position - origin;
  if ((kFeatures & kUsesCurl) != 0u)
    acceleration += turbulence(e.seed, arm, e.curl_inv_scale, e.curl_speed * float(local_tick) * kTick, e.curl_strength, e.curl_octaves);
  if ((kFeatures & kUsesVortex) != 0u) acceleration += vortex(e, arm);
  precise vec3 place = unrotate_yaw(e, arm);
  if ((kFeatures & kUsesAttractors) != 0u) {
    precise vec3 sum = vec3(0.0);
    for (uint i = 0u; i < e.attractor_count; ++i) sum += attraction(attractors[e.attractor_first + i], place);
    acceleration += rotate_yaw(e, sum);
  }
  if ((kFeatures & kUsesField) != 0u) {
    precise vec3 field = rotate_yaw(e, field_at(e, place));
    if ((e.flags & kEmitterFieldIsVelocity) != 0u) wind += field;
    else acceleration += field;
  }
  return Forces(acceleration, wind);
}

#endif
