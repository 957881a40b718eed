// Meshes as shaders read them: the triangles of all meshes of a scene one after the other, and which of them
// are one mesh.
#ifndef PLUME_SHARED_MESH_H
#define PLUME_SHARED_MESH_H

#include "shared/types.h"

PLUME_SHARED_BEGIN

// Counter-clockwise from outside: cross(edge_u, edge_v) points there.
struct MeshTriangle {
  vec3 corner;       // opposite the longest edge
  float area_until;  // share of the mesh's area up to and with this triangle: the last one's is 1
  vec3 edge_u;       // to the other two corners
  vec3 edge_v;
};

struct MeshRange {
  uint first;  // of its triangles
  uint count;
  float inv_radius;  // 1 / the farthest corner's distance from the mesh's origin
  float below;       // how far it reaches from there along -z, on which it rests
};

PLUME_SHARED_END
#endif
