// Any tick directly: every particle alive then integrates its own age in registers and is written once. Costs at most one lifetime, with
// those of its ancestors. A long way is gone in several dispatches, each of which goes on from where the one before left off.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/features.glsl"
#include "effects/lineage.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) buffer Particles { Particle particles[]; };
layout(scalar, binding = 3) readonly buffer Births { uint births[]; };   // of roots, before each tick, per span
layout(push_constant) uniform Push {
  uint threads;
  uint first_span;
  uint span_count;
};

// Which tick of the span's table bore `root`: the last one before which no more than `root` were born.
uint row_of(Span span, uint root) {
  uint low = 0u, high = span.births_count;
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (births[span.births_base + middle] <= root) low = middle;
    else high = middle;
  }
  return low;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_span, span_count);
  const uint index = thread - span.offset, birth = span.first + index;
  const uint root = birth / span.per_root;
  const uint row = row_of(span, root);
  const uint born = span.births_tick + row;
  // Those of one tick are spread evenly over it: a moving emitter leaves no clots.
  const uint before = births[span.births_base + row], after = births[span.births_base + row + 1u];
  const float part = (float(root - before) + 0.5) / float(max(after - before, 1u));

  if (born > span.tick) return;   // a later dispatch's
  const uint slot = slot_of(span, index);
  const bool goes_on = born < span.resume;
  Life life = first_life(span.emitter, birth, born, part);
  if (goes_on) life = life_in(particles[slot]);
  for (uint tick = goes_on ? span.resume - 1u : born; tick < span.tick && life.age != kDeadAge; ++tick)
    life = advance(life, span.emitter, birth, tick);
  particles[slot] = particle_of(life, birth);
}
