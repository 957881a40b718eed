// A particle's birth and one tick of its life: the single definition of motion, for the per-tick and for the catch-up kernel.
// Everything is `precise`: the two roads must agree to the bit, so no expression may be contracted differently in either.
#ifndef PLUME_EFFECTS_STEP_GLSL
#define PLUME_EFFECTS_STEP_GLSL
#include "effects/noise.glsl"
#include "shared/particle.h"

const float kTick = 1.0 / 60.0;   // s
const float kTwoPi = 6.283185307179586;

uint particle_key(EmitterData e, uint birth) { return hash_pair(e.seed, birth); }

// The n-th random number of a particle, in [0, 1).
float random(uint key, uint n) { return float(hash(key + n * 0x9e3779b9u) >> 8u) * (1.0 / 16777216.0); }

uint life_of(EmitterData e, uint key) { return e.life_min + uint(random(key, 0u) * float(e.life_max - e.life_min + 1u)); }

vec3 rotate_yaw(EmitterData e, vec3 v) {
  precise vec3 r = vec3(v.x * e.yaw_cos + v.z * e.yaw_sin, v.y, v.z * e.yaw_cos - v.x * e.yaw_sin);
  return r;
}

struct Motion {
  vec3 position;
  vec3 velocity;
  uint contact;
};

uint collisions(Motion m) { return m.contact >> kCollisionShift; }

// Around `origin`, world; `inherited` is the share of a parent's velocity, m/s.
Motion birth_motion(EmitterData e, uint key, vec3 origin, vec3 inherited) {
  const float a = random(key, 1u), b = random(key, 2u), c = random(key, 3u), d = random(key, 4u);
  precise float angle = kTwoPi * a;
  precise vec3 outward = vec3(0.0, 1.0, 0.0);
  precise vec3 place = vec3(0.0);
  precise float depth = 1.0 - e.thickness * (1.0 - pow(c, 1.0 / 3.0));   // 1 on the surface
  switch (e.shape) {
    case 1u:      // sphere
    case 2u: {    // hemisphere
      precise float y = e.shape == 1u ? 1.0 - 2.0 * b : b;
      precise float ring = sqrt(max(1.0 - y * y, 0.0));
      outward = vec3(ring * cos(angle), y, ring * sin(angle));
      place = outward * (e.radius * depth);
      break;
    }
    case 3u:      // box
      place = (vec3(a, b, c) - 0.5) * e.size;
      break;
    case 4u: {    // cone: a disc of births, directions within the half angle
      precise float disc = e.radius * (1.0 - e.thickness * (1.0 - sqrt(c)));
      precise float tilt = e.cone_angle * sqrt(b);
      place = vec3(cos(angle), 0.0, sin(angle)) * disc;
      precise float around = kTwoPi * d;
      outward = vec3(sin(tilt) * cos(around), cos(tilt), sin(tilt) * sin(around));
      break;
    }
    case 5u: {    // ring
      outward = vec3(cos(angle), 0.0, sin(angle));
      place = outward * (e.radius * (1.0 - e.thickness * b));
      break;
    }
    default: {    // point: any direction
      precise float y = 1.0 - 2.0 * b;
      precise float ring = sqrt(max(1.0 - y * y, 0.0));
      outward = vec3(ring * cos(angle), y, ring * sin(angle));
    }
  }
  Motion m;
  precise vec3 position = origin + rotate_yaw(e, place);
  precise float speed = e.speed_min + (e.speed_max - e.speed_min) * random(key, 5u);
  precise vec3 velocity = rotate_yaw(e, outward * speed) + e.velocity + inherited;
  m.position = position;
  m.velocity = velocity;
  m.contact = 0u;
  return m;
}

// Symplectic Euler with implicit drag. `age` is the particle's age in ticks before the step, `tick` its emitter's tick and `origin`
// its emitter's place then.
Motion step_motion(EmitterData e, vec3 origin, Motion m, uint age, uint tick) {
  precise vec3 acceleration = e.gravity;
  acceleration.y += e.buoyancy * exp(-float(age) * kTick * e.inv_cooling);
  precise vec3 at = (m.position - e.origin) * e.curl_inv_scale;
  at.y -= e.curl_speed * float(tick) * kTick;
  at += vec3(e.seed & 0xffu, (e.seed >> 8u) & 0xffu, (e.seed >> 16u) & 0xffu);
  precise float strength = e.curl_strength;
  for (uint octave = 0u; octave < e.curl_octaves; ++octave) {
    acceleration += strength * curl_noise(at);
    at = at * 2.03 + 17.3;
    strength *= 0.5;
  }
  precise vec2 arm = m.position.xz - origin.xz;
  precise float distance = sqrt(dot(arm, arm)) + 1e-6;
  precise float reach = distance * e.vortex_inv_radius;
  precise float swirl = e.vortex_strength * reach / (1.0 + reach * reach) * 2.0 / distance;
  acceleration.xz += vec2(-arm.y, arm.x) * swirl - arm * (e.vortex_pull / distance);

  precise vec3 velocity = m.velocity + acceleration * kTick;
  velocity = e.wind + (velocity - e.wind) / (1.0 + e.drag * kTick);
  precise vec3 position = m.position + velocity * kTick;
  if (position.y < e.floor_y) {
    position.y = e.floor_y;
    velocity.y = max(velocity.y, 0.0);
  }
  m.position = position;
  m.velocity = velocity;
  return m;
}

#endif
