// Where the coefficients of wavelets are, and what is counted beside them.
#ifndef PLUME_WAVELETS_SUMS_H
#define PLUME_WAVELETS_SUMS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct WaveletSums {
  uvec2 coefficients;  // address of floats, [cell][coefficient][channel]
  uint clamped;        // fragments whose absorbance was
  uint outside;        // fragments nearer or farther than the range of depths
};

PLUME_SHARED_END
#endif
