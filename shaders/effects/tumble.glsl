// How a piece that is a mesh lies in the world: a function of its key and its age, so that it needs no state.
//   q(t) = rotation(axis, rate t) q0     q0 uniform over all rotations (Shoemake, "Uniform random rotations", Graphics Gems III, 1992)
// A piece on the floor, stuck, or still after a collision has come to rest: its z axis is up and it stands on what it reaches below it.
// Limits: what was tumbling a tick before turns at once when it comes to rest.
#ifndef PLUME_EFFECTS_TUMBLE_GLSL
#define PLUME_EFFECTS_TUMBLE_GLSL
#include "effects/particle.glsl"
#include "shared/mesh.h"

vec4 quaternion(vec3 axis, float angle) { return vec4(axis * sin(0.5 * angle), cos(0.5 * angle)); }
vec4 quaternion_product(vec4 a, vec4 b) { return vec4(a.w * b.xyz + b.w * a.xyz + cross(a.xyz, b.xyz), a.w * b.w - dot(a.xyz, b.xyz)); }
vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

vec4 random_rotation(uint key) {
  const float a = random(key, 30u), b = kTwoPi * random(key, 31u), c = kTwoPi * random(key, 32u);
  const float s = sqrt(1.0 - a), t = sqrt(a);
  return vec4(s * sin(b), s * cos(b), t * sin(c), t * cos(c));
}

vec3 random_axis(uint key) {
  const float y = 1.0 - 2.0 * random(key, 33u), around = kTwoPi * random(key, 34u);
  return vec3(sqrt(max(1.0 - y * y, 0.0)) * vec2(cos(around), sin(around)), y).xzy;
}

const float kRestingSpeed = 0.01;   // m/s

bool is_on_floor(EmitterData e, Particle p) { return p.position.y <= e.floor_y; }
bool is_at_rest(EmitterData e, Particle p) {
  const uint contact = contact_of(p);
  const bool still = contact >= kOneCollision && dot(p.velocity, p.velocity) < kRestingSpeed * kRestingSpeed;
  return is_on_floor(e, p) || still || (contact & kStuck) != 0u;
}

struct Placed {
  vec4 rotation;
  vec3 origin;   // of the mesh, world
  float scale;   // metres for a unit of the mesh
};

Placed placed_mesh(EmitterData e, MeshRange mesh, Particle p, uint age, uint key, float radius) {
  Placed placed;
  placed.scale = radius * mesh.inv_radius;
  placed.origin = p.position;
  if (is_at_rest(e, p)) {
    const vec4 z_up = quaternion(vec3(1.0, 0.0, 0.0), -0.25 * kTwoPi);
    placed.rotation = quaternion_product(quaternion(vec3(0.0, 1.0, 0.0), kTwoPi * random(key, 34u)), z_up);
    placed.origin.y += mesh.below * placed.scale - (is_on_floor(e, p) ? 0.0 : e.body_radius);
  } else {
    const float rate = mix(e.tumble_min, e.tumble_max, random(key, 35u));
    placed.rotation = quaternion_product(quaternion(random_axis(key), rate * float(age) * kTick), random_rotation(key));
  }
  return placed;
}

vec3 place_corner(Placed placed, vec3 corner) { return placed.origin + rotated(placed.rotation, corner * placed.scale); }

// Which of the meshes of its emitter a particle is.
uint mesh_of(EmitterData e, uint key) { return e.look_mesh + hash(key + 36u) % e.look_meshes; }

#endif
