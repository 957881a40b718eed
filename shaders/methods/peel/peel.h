// Depth peeling: what a drawing counts of itself.
#ifndef PLUME_METHODS_PEEL_H
#define PLUME_METHODS_PEEL_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct PeelCounts {
  uint deepest;    // fragments of the pixel that has most
  uint fragments;  // of all pixels
  uint dropped;    // of those, left out by the limit of layers
  uint missed;     // counted at first, never found again by a peel
};

PLUME_SHARED_END
#endif
