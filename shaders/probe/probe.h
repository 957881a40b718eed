// What a probe asks: transmittance at one pixel, in front of each of `count` depths that follow in the
// buffer.
#ifndef PLUME_PROBE_H
#define PLUME_PROBE_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct ProbeQuery {
  uvec2 pixel;
  uint count;
  uint padding;
};

PLUME_SHARED_END
#endif
