// Least-significant-digit radix sort of (key, value) pairs, four bits a round, stable.
// After Satish, Harris and Garland, "Designing Efficient Sorting Algorithms for Manycore GPUs", IPDPS 2009,
// section IV.
#ifndef PLUME_SORT_RADIX_H
#define PLUME_SORT_RADIX_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kRadixThreads = 128u;
const uint kRadixPerThread = 8u;  // consecutive pairs: keeps the sort stable
const uint kRadixTile = kRadixThreads * kRadixPerThread;
const uint kRadixDigits = 16u;

PLUME_SHARED_END
#endif
