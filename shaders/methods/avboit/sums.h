// The sums of a pixel where AVBOIT accumulates integers.
#ifndef PLUME_AVBOIT_SUMS_H
#define PLUME_AVBOIT_SUMS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// Places among the sums of a pixel, of what accumulate.glsl says.
const uint kLightSum = 0u;       // rgb
const uint kNormSum = 3u;        // rgb
const uint kKnownLightSum = 6u;  // rgb
const uint kKnownNormSum = 9u;   // rgb
const uint kThroughSum = 12u;    // rgba, -log
const uint kPlainSum = 16u;      // -log of what does not tint
const uint kSums = 17u;

const float kSumSteps = 16777216.0f;
const float kNothingThrough = 128.0f;  // -log of 0

PLUME_SHARED_END
#endif
