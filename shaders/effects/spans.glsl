// Which emitter and birth a thread stands for: the spans of a kernel's emitters follow each other, and a table says in which of them each
// work group begins. So who looks for its span searches among those of its group only, however many instances there are.
#ifndef PLUME_EFFECTS_SPANS_GLSL
#define PLUME_EFFECTS_SPANS_GLSL
#include "shared/particle.h"

layout(scalar, binding = 1) readonly buffer Spans { Span spans[]; };
layout(scalar, binding = 2) readonly buffer Emitters { EmitterData emitters[]; };
layout(scalar, binding = 18) readonly buffer SpanOfGroup { uint span_of_group[]; };   // a kernel's groups, then its last span

// `first_group`: the kernel's first entry in that table.
Span span_of(uint thread, uint first_group) {
  const uint group = first_group + thread / kSpanGroup;
  uint low = span_of_group[group], high = span_of_group[group + 1u] + 1u;   // the last span whose offset is <= thread
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (spans[middle].offset <= thread) low = middle;
    else high = middle;
  }
  return spans[low];
}

// `index` counts from the span's first birth and is below its capacity.
uint slot_of(Span span, uint index) {
  const uint slot = span.first_slot + index;
  return span.base + (slot < span.capacity ? slot : slot - span.capacity);
}

#endif
