// A fragment of a list, and the pool that the lists of all pixels share.
#ifndef PLUME_METHODS_REFERENCE_H
#define PLUME_METHODS_REFERENCE_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kListEnd = 0xffffffffu;

struct FragmentNode {
  vec3 light;          // premultiplied colour + emission
  float depth;         // view depth, m
  vec3 transmittance;  // of what lies behind
  uint id;             // card index
  uint next;           // node index, or kListEnd
};

struct FragmentPool {
  uint count;  // fragments seen: beyond `capacity` they were counted, not stored
  uint capacity;
  uvec2 address;  // of FragmentNode[capacity]: pools outgrow the range of a descriptor
  uvec2 extras;   // of vec2[capacity], when outputs are wanted: haze's shift in pixels, else (presence, 0)
};

PLUME_SHARED_END
#endif
