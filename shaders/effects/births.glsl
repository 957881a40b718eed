// When a particle was born, by the table of how many roots were born before each tick.
#ifndef PLUME_EFFECTS_BIRTHS_GLSL
#define PLUME_EFFECTS_BIRTHS_GLSL
#include "effects/spans.glsl"

layout(scalar, binding = 3) readonly buffer Births { uint births[]; };   // per span

struct BirthTime {
  uint tick;    // the emitter's own, at whose end it is there
  float part;   // of the tick that had passed
};

BirthTime birth_time(Span span, uint birth) {
  const uint root = birth / span.per_root;
  uint low = 0u, high = span.births_count;   // the last tick before which no more than `root` were born
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (births[span.births_base + middle] <= root) low = middle;
    else high = middle;
  }
  // Those of one tick are spread evenly over it: a moving emitter leaves no clots.
  const uint before = births[span.births_base + low], after = births[span.births_base + low + 1u];
  return BirthTime(span.births_tick + low, (float(root - before) + 0.5) / float(max(after - before, 1u)));
}

#endif
