// What a probe asks of a method: transmittance at one pixel, in front of each of `count` points that follow
// in the buffer. And what it finds there: every fragment of the pixel.
#ifndef PLUME_PROBE_H
#define PLUME_PROBE_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

const uint kBareLight = 0xffffffffu;  // instead of a card

struct ProbeQuery {
  uvec2 pixel;
  uint count;
  uint padding;
};

// A bare light, of which nothing covers; or a fragment of the picture, whose own share a method may have to
// take out of what it has summed, or which it weighs by what the fragment is.
struct ProbedPoint {
  float depth;         // view depth, m
  uint card;           // of the fragment, or kBareLight; what follows is of a fragment
  vec3 transmittance;  // of what lies behind
  vec3 color;          // premultiplied by coverage
  float coverage;
  vec3 emission;
};

struct ProbedFragment {
  vec3 color;  // premultiplied by coverage
  float coverage;
  vec3 emission;
  float depth;         // view depth, m
  vec3 transmittance;  // of what lies behind
  uint card;
};

// Before the fragments.
struct ProbedCount {
  uint count;  // found: beyond `capacity` they were counted, not stored
  uint capacity;
};

PLUME_SHARED_END
#endif
