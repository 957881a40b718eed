// One tick for every particle of every awake emitter: births at this tick appear, the others move, the old die.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/spans.glsl"
#include "effects/step.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) buffer Particles { Particle particles[]; };
layout(push_constant) uniform Push {
  uint threads;
  uint span_count;
  uint tick;   // of the scene, after this step
};

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, span_count);
  const EmitterData e = emitters[span.emitter];
  const uint birth = span.first + (thread - span.offset);
  const uint slot = slot_of(span, birth);
  const uint key = particle_key(e, birth);
  if (birth >= span.fresh) {
    particles[slot] = living_particle(birth_motion(e, key), span.emitter, birth, 0u);
    return;
  }
  const Particle p = particles[slot];
  const uint age = p.age_and_emitter & kDeadAge;
  if (age == kDeadAge) return;
  if (age + 1u >= life_of(e, key)) {
    particles[slot] = dead_particle(span.emitter, birth);
    return;
  }
  const Motion m = step_motion(e, Motion(p.position, p.velocity), age, tick - 1u);
  particles[slot] = living_particle(m, span.emitter, birth, age + 1u);
}
