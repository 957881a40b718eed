// The exact layers of a pixel: its nearest fragments of sharp cards, in the order of their depth.
#ifndef PLUME_AVBOIT_EXACT_LAYERS_H
#define PLUME_AVBOIT_EXACT_LAYERS_H

#include "methods/avboit/volume.h"
#include "shared/types.h"

PLUME_SHARED_BEGIN

// A layer is a 64-bit key: its place along the ray, above 10 bits of each channel's transmittance. The place
// is the bits of the view depth without the last few, where the card's index stands instead: cards of one
// depth hide each other in the order of their indices, as in the reference.
const uint kTieMask = 63u;
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
// Optical depth of a layer as it counts in the tail, one value for all channels.
float tail_depth(uint packed) {
  return -log(max(dot(unpack_layer(packed), vec3(1.0 / 3.0)), kLeastTransmittance));
}
uint layer_place(float depth, uint id) {
  return (floatBitsToUint(depth) & ~kTieMask) | (id & kTieMask);
}
float layer_depth(uint place) {
  return uintBitsToFloat(place & ~kTieMask);
}
// Of a fragment. Never the fragment itself, though its depth differs by a rounding from that of the draw
// which made the layer.
bool layer_in_front(uint place, float depth, uint id) {
  const uint mine = layer_place(depth, id);
  const bool itself =
      (place & kTieMask) == (mine & kTieMask) && layer_depth(place) > layer_depth(mine) * 0.99998;
  return place < mine && !itself;
}
#endif
#endif
