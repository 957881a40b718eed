// A fixed number of nodes for each pixel, which fragments enter in turn.
#ifndef PLUME_PIXEL_NODES_H
#define PLUME_PIXEL_NODES_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// Addresses of arrays [node][pixel], which outgrow the range of a descriptor.
struct NodeArrays {
  uvec2 keys;  // of uvec2: card, then bits of the view depth in m. As one 64-bit number: order along the ray
  uvec2 through;  // of vec3: transmittance
  uvec2 light;    // of vec3: premultiplied colour + emission, where the method keeps it
};

// What did not get a node of its own.
struct NodeOverflow {
  uint fragments;
  uint pixels;  // with at least one
};

const uint kTurnTaken = 0x80000000u;  // a fragment is at work in the pixel; below it, how many had their turn

PLUME_SHARED_END
#endif
