// An analytic opaque body: rasterised as a small procedural mesh, and intersected exactly for shadows.
#ifndef PLUME_SHARED_SOLID_H
#define PLUME_SHARED_SOLID_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

struct SolidData {
  vec3 position;   // box, sphere: centre; plane: a point; capsule: one end
  uint kind;       // SolidKind
  vec3 end;        // capsule: other end
  uint material;   // Material
  vec3 half_size;  // box; plane in x and z
  float radius;
  vec3 color;
  float yaw_sin;
  float yaw_cos;
};

const uint kSolidPlane = 0u;
const uint kSolidBox = 1u;
const uint kSolidSphere = 2u;
const uint kSolidCapsule = 3u;
const uint kMaterialUnlit = 5u;                            // colour is radiance
const uint kSolidRing = 16u;                               // facets around a sphere or capsule
const uint kSolidVertices = kSolidRing * kSolidRing * 6u;  // of the finest mesh

PLUME_SHARED_END
#endif
