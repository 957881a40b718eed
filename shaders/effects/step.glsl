// One tick of a particle's life: the single definition of motion, for the per-tick and for the catch-up kernel.
// Everything is `precise`: the two roads must agree to the bit, so no expression may be contracted differently in either.
#ifndef PLUME_EFFECTS_STEP_GLSL
#define PLUME_EFFECTS_STEP_GLSL
#include "effects/collide.glsl"
#include "effects/forces.glsl"
#include "effects/particle.glsl"

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
