// Where a coloured event shares its slice with another one: chromaticity skew cannot tell them apart there.
#ifndef PLUME_AVBOIT_OVERLAP_H
#define PLUME_AVBOIT_OVERLAP_H

#include "methods/avboit/volume.h"

PLUME_SHARED_BEGIN

struct Overlap {  // of a ray, one bit a slice
  uint coloured[kMaskWords];
  uint shared_slices[kMaskWords];  // reached by more than one event
};

PLUME_SHARED_END
#endif
