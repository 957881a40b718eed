// Circles of confusion: their limits, and what the two shaders of depth of field are told.
#ifndef PLUME_POST_LENS_H
#define PLUME_POST_LENS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kMostCircleOfHeight = 16u;  // no circle's radius is more than this part of the picture's height
const uint kLeastTilePixels = 8u;      // tiles are as wide as the largest radius, so that 3 x 3 reach it

struct LensPush {
  uvec2 size;        // pixels
  uvec2 tiles;       // of tile_pixels, rounded up
  uint tile_pixels;  // each way
  float focus_m;     // view depth that is sharp
  float aperture_m;  // diameter of the lens
};

PLUME_SHARED_END
#endif
