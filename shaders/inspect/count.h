// Counting fragments: in parts of one, so that a fragment of a draw at lower resolution can be shared out.
#ifndef PLUME_INSPECT_COUNT_H
#define PLUME_INSPECT_COUNT_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kCountConstant = 10u;  // id of the one in count.frag: behind those of every vertex shader
const uint kPartsOfAFragment = 16u;

PLUME_SHARED_END
#endif
