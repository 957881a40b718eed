// AVBOIT, splat of scalar sources: the optical depth of each fragment into the packed fields of its ray. How a field that
// overflows is met (kOverflow):
//   ignored: the carry falsifies the slices behind;  compare-exchange: the field saturates, in a loop;
//   first overflow: atomicAdd returns the old word, so the add that passes the field knows it and the first such slice is kept;
//   behind it T = 0, so that carries do not matter.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/overlap.h"
#include "methods/avboit/splat_surface.glsl"

layout(constant_id = 3) const uint kLaneBits = 16u;
layout(constant_id = 4) const uint kOverflow = 2u;   // 0 ignored, 1 compare-exchange, 2 first overflow
layout(scalar, binding = 10) buffer Extinction { uint extinction[]; };
layout(scalar, binding = 11) buffer Overflow { uint overflow[]; };

layout(constant_id = 5) const uint kWatchOverlap = 0u;
layout(scalar, binding = 12) buffer Overlaps { Overlap overlaps[]; };

const uint kLanes = 32u / kLaneBits;

uint field_of(uint word, uint slice) { return (word >> (kLaneBits * (slice % kLanes))) & full_field(kLaneBits); }
uint field_at(uint value, uint slice) { return value << (kLaneBits * (slice % kLanes)); }

void note_overflow(uint slice, uint old_word, uint added) {
  if (kOverflow == 2u && field_of(old_word, slice) + added > full_field(kLaneBits)) atomicMin(overflow[ray_index()], slice);
}

void note_overlap(uint slice, bool taken) {
  const uint bit = 1u << (slice & 31u);
  const vec3 t = v_transmission.rgb;
  if (t.r != t.g || t.g != t.b) atomicOr(overlaps[ray_index()].coloured[slice / 32u], bit);
  if (taken) atomicOr(overlaps[ray_index()].shared_slices[slice / 32u], bit);
}

void add_saturating(uint index, uint slice, uint added) {
  uint expected = 0u;
  for (;;) {
    const uint old = field_of(expected, slice);
    const uint sum = min(old + added, full_field(kLaneBits));
    const uint found = atomicCompSwap(extinction[index], expected, expected + field_at(sum - old, slice));
    if (found == expected) return;
    expected = found;
  }
}

void main() {
  if (hidden()) return;
  const float through = dot(passed_by(v_ambient.a * cell_density()), vec3(1.0 / 3.0));
  const float tau = -log(max(through, kLeastTransmittance));
  const Place place = place_of(v_uv_depth.z);
  const uint here = quantise(tau * (1.0 - place.beyond), kLaneBits, rounding(0u));
  const uint beyond = place.beyond > 0.0 ? quantise(tau * place.beyond, kLaneBits, rounding(1u)) : 0u;

  const uint first = ray_index() * (volume.slices / kLanes) + place.slice / kLanes, next = place.slice + 1u;
  if (kOverflow == 1u) {
    if (here != 0u) add_saturating(first, place.slice, here);
    if (beyond != 0u) add_saturating(first + (next % kLanes == 0u ? 1u : 0u), next, beyond);
  } else if (next % kLanes != 0u) {   // both slices lie in one word
    const uint added = field_at(here, place.slice) + field_at(beyond, next);
    if (added == 0u) return;
    const uint old_word = atomicAdd(extinction[first], added);
    if (kWatchOverlap != 0u) {
      note_overlap(place.slice, field_of(old_word, place.slice) != 0u);
      note_overlap(next, field_of(old_word, next) != 0u);
    }
    note_overflow(place.slice, old_word, here);
    note_overflow(next, old_word, beyond);
  } else {
    const uint old_word = here != 0u ? atomicAdd(extinction[first], field_at(here, place.slice)) : 0u;
    const uint old_next = beyond != 0u ? atomicAdd(extinction[first + 1u], beyond) : 0u;
    note_overflow(place.slice, old_word, here);
    note_overflow(next, old_next, beyond);
    if (kWatchOverlap != 0u) {
      note_overlap(place.slice, field_of(old_word, place.slice) != 0u);
      if (beyond != 0u) note_overlap(next, field_of(old_next, next) != 0u);
    }
  }
}
