// Numbers that nothing can be drawn with. NaN and infinity spread through every sum that they meet, of light
// as of colours, and so do lengths whose fourth power is more than a float holds: what has one is left out
// and counted. Told by their bits, about which no compiler assumes anything.
#ifndef PLUME_SHARED_BAD_NUMBER_H
#define PLUME_SHARED_BAD_NUMBER_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// What a frame left out, by index: cards, then pieces of opaque debris in the order of their draws.
struct BadCards {
  uint count;
  uint first;  // the least of them; ~0: there is none
};

const float kFarthest = 1e9f;  // m, and m/s

#ifdef __cplusplus
using glm::floatBitsToUint;
using glm::max;
inline
#endif
    bool
    is_bad(float number) {
  return (floatBitsToUint(number) & 0x7F800000u) == 0x7F800000u;
}

// Of a place, a length or a velocity: beyond kFarthest too.
#ifdef __cplusplus
inline
#endif
    bool
    is_bad(vec3 lengths) {
  const uvec3 sizes = floatBitsToUint(lengths) & 0x7FFFFFFFu;
  return max(max(sizes.x, sizes.y), sizes.z) > floatBitsToUint(kFarthest);
}

PLUME_SHARED_END
#endif
