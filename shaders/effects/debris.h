// One draw of opaque particles: the pieces of one emitter.
#ifndef PLUME_EFFECTS_DEBRIS_H
#define PLUME_EFFECTS_DEBRIS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// As of the emitter's Span.
struct DebrisDraw {
  uint emitter;
  uint first;
  uint base;
  uint capacity;
  uint first_slot;
};

// `index` counts from the draw's first birth and is below the capacity.
#ifdef __cplusplus
inline
#endif
    uint
    slot_of(DebrisDraw drawn, uint index) {
  const uint slot = drawn.first_slot + index;
  return drawn.base + (slot < drawn.capacity ? slot : slot - drawn.capacity);
}

PLUME_SHARED_END
#endif
