// How coloured transmission is treated: AVBOIT's chromatic modes.
#ifndef PLUME_AVBOIT_COLOUR_H
#define PLUME_AVBOIT_COLOUR_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kMono = 0u;             // one transmittance for all colours
const uint kTotalExtinction = 1u;  // the background is seen through all colours; everything else through one
const uint kSkew = 2u;             // and the transparent image is tinted by their product in resolve
const uint kFirstEvent = 3u;       // and what is drawn is tinted inversely by its own colour before
const uint kFullRgb = 4u;          // a transmittance for each channel

PLUME_SHARED_END

#ifndef __cplusplus
float luma(vec3 c) {
  return dot(c, vec3(0.2126, 0.7152, 0.0722));
}  // Rec. 709
#endif
#endif
