// The state of a particle at the span's tick: from the pool, or, where the emitter is analytic and keeps none, from its age.
#ifndef PLUME_EFFECTS_STATE_GLSL
#define PLUME_EFFECTS_STATE_GLSL
#include "effects/ballistic.glsl"
#include "effects/births.glsl"
#include "effects/features.glsl"
#include "effects/path.glsl"
#include "effects/shapes.glsl"

layout(scalar, binding = 0) readonly buffer Particles { Particle particles[]; };

// `index` counts from the span's first birth and is below its count.
Particle particle_at(Span span, uint index) {
  if ((kFeatures & kIsAnalytic) == 0u) return particles[slot_of(span, index)];
  const uint birth = span.first + index;
  const EmitterData e = emitters[span.emitter];
  const uint key = particle_key(e, birth);
  const BirthTime time = birth_time(span, birth);
  const uint age = span.tick - time.tick;
  if (age >= life_of(e, key)) return Particle(vec3(0.0), birth, vec3(0.0), kDeadAge);
  const Motion born = birth_motion(e, key, origin_at(e, float(time.tick) - 1.0 + time.part), vec3(0.0));
  const Motion now = ballistic(e, born, age);
  return Particle(now.position, birth, now.velocity, age);
}

#endif
