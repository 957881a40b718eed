// Stochastic transparency: one round of random sample masks.
#ifndef PLUME_METHODS_STOCHASTIC_H
#define PLUME_METHODS_STOCHASTIC_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kSamplesARound = 4u;

struct StochasticRound {
  uint seed;
  uint round;
};

PLUME_SHARED_END
#endif
