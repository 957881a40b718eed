// Integer hashing: the one source of randomness. PCG-style output mix (Jarzynski and Olano, "Hash Functions
// for GPU Rendering", JCGT 9(3), 2020, pcg). Identical in C++ and GLSL.
#ifndef PLUME_SHARED_HASH_H
#define PLUME_SHARED_HASH_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

#ifdef __cplusplus
inline
#endif
    uint
    hash(uint x) {
  const uint state = x * 747796405u + 2891336453u;
  const uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

#ifdef __cplusplus
inline
#endif
    uint
    hash_pair(uint a, uint b) {
  return hash(a ^ hash(b));
}

PLUME_SHARED_END
#endif
