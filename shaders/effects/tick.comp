// One tick for every particle of every awake emitter of this kernel that was there before: it moves, or dies. Births are a seek to age 0.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/features.glsl"
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
  const uint slot = slot_of(span, index);
  const Particle p = particles[slot];
  if (age_of(p) == kDeadAge) return;
  particles[slot] = particle_of(advance(life_in(p), emitters[span.emitter], span.emitter, birth, span.tick - 1u), birth);
}
