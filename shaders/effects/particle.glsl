// Who a particle is, whatever moves it: its random numbers, its life, and how its state is packed.
#ifndef PLUME_EFFECTS_PARTICLE_GLSL
#define PLUME_EFFECTS_PARTICLE_GLSL
#include "shared/bad_number.h"
#include "shared/hash.h"
#include "shared/particle.h"

const float kTick = 1.0 / 60.0;   // s
const float kTwoPi = 6.283185307179586;

uint particle_key(EmitterData e, uint birth) { return hash_pair(e.seed, birth); }

// The n-th random number of a particle, in [0, 1).
float random(uint key, uint n) { return float(hash(key + n * 0x9e3779b9u) >> 8u) * (1.0 / 16777216.0); }

uint life_of(EmitterData e, uint key) { return e.life_min + uint(random(key, 0u) * float(e.life_max - e.life_min + 1u)); }

// From the emitter's frame to the world, and back.
vec3 rotate_yaw(EmitterData e, vec3 v) {
  precise vec3 r = vec3(v.x * e.yaw_cos + v.z * e.yaw_sin, v.y, v.z * e.yaw_cos - v.x * e.yaw_sin);
  return r;
}
vec3 unrotate_yaw(EmitterData e, vec3 v) {
  precise vec3 r = vec3(v.x * e.yaw_cos - v.z * e.yaw_sin, v.y, v.z * e.yaw_cos + v.x * e.yaw_sin);
  return r;
}

struct Motion {
  vec3 position;
  vec3 velocity;
  uint contact;   // kStuck | kKilled | events
};

uint collisions(Motion m) { return m.contact / kOneCollision; }

uint age_of(Particle p) { return p.state & kDeadAge; }
uint contact_of(Particle p) { return (p.state >> kContactShift) & ((1u << kContactBits) - 1u); }
uint generation_of(Particle p) { return p.state >> kGenerationShift; }
bool is_bad(Particle p) { return is_bad(p.position) || is_bad(p.velocity); }

#endif
