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

PLUME_SHARED_END
#endif
