// What emitters move by and meet, of variable number: each emitter names ranges of these tables. Attractors,
// kill volumes and the field are in the emitter's frame, so that all instances of an effect share them;
// colliders are in the world.
#ifndef PLUME_SHARED_MOTION_TABLES_H
#define PLUME_SHARED_MOTION_TABLES_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// Pulls towards the nearest point of the segment.
struct AttractorData {
  vec3 from;
  float scale;  // 2^(3/2) strength / radius: acceleration = scale * arm / (1 + (arm / radius)^2)^(3/2)
  vec3 along;   // to the other end
  float inv_radius;
};

const uint kKillBox = 0u;
const uint kKillSphere = 1u;
const uint kKillPlane = 2u;  // what is behind it
struct KillVolumeData {
  vec3 position;
  uint kind;
  vec3 extent;   // box: half size; sphere: radius in x; plane: unit normal
  uint outside;  // 1: kills what is not inside
};

// A solid box turned about +y.
struct BoxCollider {
  vec3 position;
  float depth;  // the solid goes on so far below it: a plane is the top of a deep box
  vec3 half_size;
  float yaw_sin;
  float yaw_cos;
};

// A capsule; a sphere is one of no length.
struct RoundCollider {
  vec3 position;
  float radius;
  vec3 axis;  // unit, or 0 where there is no length
  float length_m;
};

PLUME_SHARED_END
#endif
