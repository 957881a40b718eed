// The bounded A-buffer: so many layers a pixel, [layer][pixel], reached by address since they outgrow the
// range of a descriptor.
#ifndef PLUME_ABUFFER_BOUNDED_H
#define PLUME_ABUFFER_BOUNDED_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct BoundedLayers {
  uvec2 keys;      // address of 64-bit words, kFree where nothing is
  uvec2 payloads;  // address of uvec2, with a transmittance for each channel
  uint overflowed_fragments;
  uint overflowed_pixels;
};

const uint kFree = 0xffffffffu;  // in both halves of a key: behind everything

PLUME_SHARED_END
#endif
