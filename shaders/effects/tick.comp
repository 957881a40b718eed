// One tick for every particle of every awake emitter that was there before: it moves, or dies. Births are a seek to age 0.
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
  const uint index = thread - span.offset, birth = span.first + index;
  const uint slot = slot_of(span, index);
  const uint key = particle_key(e, birth);
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
