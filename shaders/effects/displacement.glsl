// Curl noise may displace what is drawn, and nothing else: the state stays where forces brought it.
#ifndef PLUME_EFFECTS_DISPLACEMENT_GLSL
#define PLUME_EFFECTS_DISPLACEMENT_GLSL
#include "effects/features.glsl"
#include "effects/noise.glsl"
#include "effects/particle.glsl"

// Where a particle of that age is drawn. `tick` is the emitter's.
vec3 displaced(EmitterData e, vec3 position, uint age, uint tick) {
  if ((kFeatures & kUsesDisplacement) == 0u) return position;
  const float drift = e.displacement_speed * float(tick) * kTick;
  const float grown = min(float(age) * e.displacement_per_tick, 1.0);
  return position +
         turbulence(e.seed, position - e.origin, e.displacement_inv_m, drift, e.displacement_m * grown, e.displacement_octaves);
}

#endif
