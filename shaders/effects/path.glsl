// Scripted paths of emitters.
#ifndef PLUME_EFFECTS_PATH_GLSL
#define PLUME_EFFECTS_PATH_GLSL
#include "shared/particle.h"

layout(scalar, binding = 4) readonly buffer PathKeys { PathKey path_keys[]; };

// Where the emitter is at its own tick: linear between the keys of its path. Keys are whole ticks up to 2^24, which floats hold; what they
// hold of the part of a tick at which a birth is becomes coarser on the way there: 1/16 of a tick after 2^20 (5 hours), none at 2^24.
vec3 origin_at(EmitterData e, float tick) {
  precise vec3 origin = e.origin;
  if ((kFeatures & kUsesPath) != 0u && e.path_count > 0u) {
    PathKey after = path_keys[e.path_first], before = after;
    for (uint i = 1u; i < e.path_count && after.tick < tick; ++i) {
      before = after;
      after = path_keys[e.path_first + i];
    }
    precise float along = after.tick > before.tick ? clamp((tick - before.tick) / (after.tick - before.tick), 0.0, 1.0) : 0.0;
    origin += before.offset + (after.offset - before.offset) * along;
  }
  return origin;
}

#endif
