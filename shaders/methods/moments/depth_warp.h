// Depths of moments: warped to [-1, 1] between bounds that enclose every fragment,
//   w(z) = 2 (ln z - ln nearest) / (ln farthest - ln nearest) - 1.
#ifndef PLUME_MOMENTS_DEPTH_WARP_H
#define PLUME_MOMENTS_DEPTH_WARP_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct DepthWarp {
  float scale;  // w = log2(z) * scale + offset
  float offset;
};

// Positive floats are ordered as their bits are; the nearest one is kept as the greatest complement.
struct DepthBounds {
  uint not_nearest;
  uint farthest;
};

PLUME_SHARED_END
#endif
