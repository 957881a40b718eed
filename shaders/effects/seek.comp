// Any tick directly: every particle alive then integrates its own age in registers and is written once. Costs at most one lifetime, with
// those of its ancestors. A long way is gone in several dispatches, each of which goes on from where the one before left off.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/features.glsl"
#include "effects/births.glsl"
#include "effects/lineage.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) buffer Particles { Particle particles[]; };
layout(push_constant) uniform Push {
  uint threads;
  uint first_group;
};

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_group);
  const uint index = thread - span.offset, birth = span.first + index;
  const BirthTime time = birth_time(span, birth);
  const uint born = time.tick;
  if (born > span.tick) return;   // a later dispatch's
  const uint slot = slot_of(span, index);
  const bool goes_on = born < span.resume;
  Life life = first_life(span.emitter, birth, born, time.part);
  if (goes_on) life = life_in(particles[slot]);
  const EmitterData own = emitters[span.emitter];
  for (uint tick = goes_on ? span.resume - 1u : born; tick < span.tick && life.age != kDeadAge; ++tick)
    life = advance(life, own, span.emitter, birth, tick);
  particles[slot] = particle_of(life, birth);
}
