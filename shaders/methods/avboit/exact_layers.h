// The exact layers of a pixel: its nearest fragments of sharp cards, in the order of their depth.
#ifndef PLUME_AVBOIT_EXACT_LAYERS_H
#define PLUME_AVBOIT_EXACT_LAYERS_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// A layer is a 64-bit key: bits of the view depth, above 10 bits of each channel's transmittance.
const uint kLayerSteps = 1023u;
const float kTailSteps = 4096.0f;   // of the tail, a unit of optical depth
const uint kNoLayer = 0xffffffffu;  // in both halves: farther than any

PLUME_SHARED_END

#ifndef __cplusplus
uint pack_layer(vec3 t) {
  const uvec3 q = uvec3(t * float(kLayerSteps) + 0.5);
  return q.r | q.g << 10 | q.b << 20;
}
vec3 unpack_layer(uint word) {
  return vec3(uvec3(word, word >> 10, word >> 20) & kLayerSteps) / float(kLayerSteps);
}
#endif
#endif
