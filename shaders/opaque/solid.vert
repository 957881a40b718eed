// Procedural meshes of the scene's solids: one instance a solid; vertices beyond a kind's need collapse.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/solid.h"
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Solids { SolidData solids[]; };

invariant gl_Position;   // the depth pass and the shading must agree to the bit
layout(location = 0) out vec3 v_world;
layout(location = 1) out vec3 v_normal;
layout(location = 2) flat out uint v_solid;

const uvec2 kQuad[6] = uvec2[](uvec2(0, 0), uvec2(1, 0), uvec2(1, 1), uvec2(0, 0), uvec2(1, 1), uvec2(0, 1));

vec3 turn(SolidData s, vec3 v) { return vec3(v.x * s.yaw_cos + v.z * s.yaw_sin, v.y, v.z * s.yaw_cos - v.x * s.yaw_sin); }

void box(SolidData s, uint vertex) {
  const uint face = vertex / 6u, axis = face % 3u;
  const float side = face < 3u ? 1.0 : -1.0;
  const vec2 uv = vec2(kQuad[vertex % 6u]) * 2.0 - 1.0;
  vec3 normal = vec3(0.0), corner;
  normal[axis] = side;
  corner[axis] = side;
  corner[(axis + 1u) % 3u] = uv.x;
  corner[(axis + 2u) % 3u] = uv.y;
  v_normal = turn(s, normal);
  v_world = s.position + turn(s, corner * s.half_size);
}

// A capsule from `position` to `end`; a sphere is one of no length.
void capsule(SolidData s, uint vertex) {
  const uvec2 cell = uvec2((vertex / 6u) % kSolidRing, vertex / 6u / kSolidRing) + kQuad[vertex % 6u];
  const float around = 6.2831853 * float(cell.x) / float(kSolidRing);
  const float along = 3.1415927 * float(cell.y) / float(kSolidRing);   // pole to pole
  const vec3 axis = length(s.end - s.position) > 1e-5 ? normalize(s.end - s.position) : vec3(0.0, 1.0, 0.0);
  const vec3 side = normalize(abs(axis.y) < 0.9 ? cross(axis, vec3(0.0, 1.0, 0.0)) : cross(axis, vec3(1.0, 0.0, 0.0)));
  v_normal = axis * cos(along) + (side * cos(around) + cross(axis, side) * sin(around)) * sin(along);
  v_world = (cell.y <= kSolidRing / 2u ? s.end : s.position) + v_normal * s.radius;
}

void main() {
  const SolidData s = solids[gl_InstanceIndex];
  const uint vertex = gl_VertexIndex;
  v_solid = gl_InstanceIndex;
  v_world = s.position;
  v_normal = vec3(0.0, 1.0, 0.0);
  const uint used = s.kind == kSolidPlane ? 6u : s.kind == kSolidBox ? 36u : kSolidVertices;
  if (vertex >= used) {
    gl_Position = vec4(0.0, 0.0, -1.0, 1.0);   // in front of everything that is drawn: clipped
    return;
  }
  if (s.kind == kSolidPlane) {
    const vec2 uv = vec2(kQuad[vertex]) * 2.0 - 1.0;
    v_world = s.position + vec3(uv.x * s.half_size.x, 0.0, uv.y * s.half_size.z);
  } else if (s.kind == kSolidBox) {
    box(s, vertex);
  } else {
    capsule(s, vertex);
  }
  gl_Position = view.view_projection * vec4(v_world, 1.0);
}
