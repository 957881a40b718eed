// What is counted of the fragments whose absorbance is summed.
#ifndef PLUME_ABSORBANCE_COUNTS_H
#define PLUME_ABSORBANCE_COUNTS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct AbsorbanceCounts {
  uint clamped;  // fragments that absorb more than is kept
  uint outside;  // fragments nearer or farther than the scene's range of depths
};

PLUME_SHARED_END
#endif
