// Which emitter and birth a thread stands for: the spans of a kernel's emitters follow each other.
#ifndef PLUME_EFFECTS_SPANS_GLSL
#define PLUME_EFFECTS_SPANS_GLSL
#include "shared/particle.h"

layout(scalar, binding = 1) readonly buffer Spans { Span spans[]; };
layout(scalar, binding = 2) readonly buffer Emitters { EmitterData emitters[]; };

Span span_of(uint thread, uint first_span, uint span_count) {
  uint low = first_span, high = first_span + span_count;   // the last span whose offset is <= thread
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
