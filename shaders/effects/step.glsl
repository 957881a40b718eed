// A particle's birth and one tick of its life: the single definition of motion, for the per-tick and for the catch-up kernel.
// Everything is `precise`: the two roads must agree to the bit, so no expression may be contracted differently in either.
#ifndef PLUME_EFFECTS_STEP_GLSL
#define PLUME_EFFECTS_STEP_GLSL
#include "effects/collide.glsl"
#include "effects/forces.glsl"
#include "effects/particle.glsl"

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

// Symplectic Euler with implicit drag, then the way is cleared: v += a dt; v = u + (v - u) / (1 + drag dt), u the wind; x += v dt.
// `origin` is where the emitter is at this tick, `age` the particle's age in ticks before the step, `local_tick` counts from the call.
Motion step_motion(EmitterData e, vec3 origin, Motion m, uint age, uint local_tick) {
  if ((m.contact & (kStuck | kKilled)) != 0u) return m;
  const Forces forces = forces_on(e, origin, m, age, local_tick);
  precise vec3 velocity = m.velocity + forces.acceleration * kTick;
  velocity = forces.wind + (velocity - forces.wind) / (1.0 + e.drag * kTick);
  precise vec3 position = m.position + velocity * kTick;
  if ((kFeatures & kUsesOrbit) != 0u) {   // on a turntable: what it adds vanishes exactly at no angle
    precise vec2 arm = position.xz - origin.xz;
    position.xz += vec2(arm.x * e.orbit_cos_less + arm.y * e.orbit_sin, arm.y * e.orbit_cos_less - arm.x * e.orbit_sin);
    velocity.xz += vec2(velocity.x * e.orbit_cos_less + velocity.z * e.orbit_sin, velocity.z * e.orbit_cos_less - velocity.x * e.orbit_sin);
  }
  Motion next = Motion(position, velocity, m.contact);
  if ((kFeatures & kUsesCollision) != 0u) next = collide(e, m, next, age);
  if (next.position.y < e.floor_y) {
    next.position.y = e.floor_y;
    next.velocity.y = max(next.velocity.y, 0.0);
  }
  if ((kFeatures & kUsesKill) != 0u && is_killed(e, origin, m.position, next.position)) next.contact |= kKilled;
  return next;
}

#endif
