// Any tick directly: every particle alive then integrates its own age in registers and is written once. Costs at most one lifetime.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/spans.glsl"
#include "effects/step.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) writeonly buffer Particles { Particle particles[]; };
layout(scalar, binding = 3) readonly buffer Births { uint births[]; };   // born up to and including each tick, per span
layout(push_constant) uniform Push {
  uint threads;
  uint span_count;
  uint tick;
};

// The first tick by which more than `birth` were born.
uint birth_tick(Span span, uint birth) {
  uint low = 0u, high = span.births_count - 1u;
  while (low < high) {
    const uint middle = (low + high) / 2u;
    if (births[span.births_base + middle] > birth) high = middle;
    else low = middle + 1u;
  }
  return span.births_tick + low;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, span_count);
  const EmitterData e = emitters[span.emitter];
  const uint index = thread - span.offset, birth = span.first + index;
  const uint slot = slot_of(span, index);
  const uint key = particle_key(e, birth);
  const uint born = e.call_tick + birth_tick(span, birth);
  const uint age = tick - born;
  if (age >= life_of(e, key)) {
    particles[slot] = dead_particle(span.emitter, birth);
    return;
  }
  Motion m = birth_motion(e, key);
  for (uint a = 0u; a < age; ++a) m = step_motion(e, m, a, born + a);
  particles[slot] = living_particle(m, span.emitter, birth, age);
}
