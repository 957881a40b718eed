// Optical depth of a puff texel is stored relative to the mean over the card, in units of this: 3, so that 1
// is 85/255 exactly.
#ifndef PLUME_SURFACE_TEXTURE_DEPTH_H
#define PLUME_SURFACE_TEXTURE_DEPTH_H
#include "shared/types.h"
PLUME_SHARED_BEGIN
const float kTextureDepth = 3.0f;
PLUME_SHARED_END
#endif
