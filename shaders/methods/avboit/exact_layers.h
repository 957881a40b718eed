// The exact layers of a pixel: its nearest fragments of sharp cards, in the order of their depth.
#ifndef PLUME_AVBOIT_EXACT_LAYERS_H
#define PLUME_AVBOIT_EXACT_LAYERS_H

#include "methods/avboit/volume.h"
#include "shared/types.h"

PLUME_SHARED_BEGIN

// A layer is a 64-bit key: its place along the ray, above its transmittance. The place is the bits of the
// view depth without the last few, where the card's index stands instead: cards of one depth hide each other
// in the order of their indices, as in the reference. Transmittance is 10 bits a channel, or, marked by the
// highest bit, 23 bits of one value for all: little light through something black may still be bright.
const uint kTieMask = 63u;
const uint kLayerSteps = 1023u;
const uint kGrayLayer = 0x80000000u;
const uint kGraySteps = 0x7fffffu;  // and a half is a float too, so that 1 stays 1
const uint kNoLayer = 0xffffffffu;  // in both halves: farther than any

// What falls off the end of a pixel's layers, as one slab of smoke: sums that no order of draws changes.
struct LayerTail {
  uvec3 depth;    // optical depth of each channel, in kTailSteps a unit
  uint places;    // the sum of the mean of that times the place, see tail_place()
  uint before;    // the complement of the bits of its nearest depth, 0 where there is none
  uint farthest;  // the bits of its farthest depth
};
const float kTailSteps = 32768.0f;
const float kTailMostDepth = 8.0f;          // of one fragment
const uint kTailFull = 0x80000000u;         // black long since: no more is added, so that it never wraps
const float kTailOctavesBelowMetre = 8.0f;  // of tail_place()
const float kTailOctaves = 32.0f;

PLUME_SHARED_END

#ifndef __cplusplus
uint pack_layer(vec3 t) {
  if (t.r == t.g && t.g == t.b) return kGrayLayer | uint(t.r * float(kGraySteps) + 0.5);
  const uvec3 q = uvec3(t * float(kLayerSteps) + 0.5);
  return q.r | q.g << 10 | q.b << 20;
}
vec3 unpack_layer(uint word) {
  if ((word & kGrayLayer) != 0u) return vec3(float(word & kGraySteps) / float(kGraySteps));
  return vec3(uvec3(word, word >> 10, word >> 20) & kLayerSteps) / float(kLayerSteps);
}
// Optical depth of a layer as it counts in the tail.
vec3 tail_depth(uint packed) {
  return min(-log(max(unpack_layer(packed), vec3(kLeastTransmittance))), kTailMostDepth);
}
// Where a depth lies among those of the tail: linear in its logarithm, 0 to 1 from 4 mm to 16,000 km.
float tail_place(float depth) {
  return clamp((log2(depth) + kTailOctavesBelowMetre) / kTailOctaves, 0.0, 1.0);
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
