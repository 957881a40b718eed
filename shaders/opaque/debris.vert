// Opaque particles: one instance a piece of one emitter, the faces of its mesh pulled by vertex; those beyond it and the pieces that are
// dead, bad or not born yet collapse. Faces are flat.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/debris.h"
#include "effects/look.glsl"
#include "effects/tumble.glsl"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 2) readonly buffer Emitters { EmitterData emitters[]; };
layout(scalar, binding = 3) readonly buffer Particles { Particle particles[]; };
layout(scalar, binding = 6) readonly buffer MeshRanges { MeshRange mesh_ranges[]; };
layout(scalar, binding = 7) readonly buffer MeshTriangles { MeshTriangle mesh_triangles[]; };
layout(push_constant, scalar) uniform Push { DebrisDraw drawn; };

invariant gl_Position;   // the depth pass and the shading must agree to the bit
layout(location = 0) out vec3 v_world;
layout(location = 1) flat out vec3 v_normal;
layout(location = 2) flat out vec4 v_albedo;   // a: 0 = not lit
layout(location = 3) flat out vec3 v_emission;

void main() {
  gl_Position = vec4(0.0, 0.0, -1.0, 1.0);   // in front of everything that is drawn: clipped
  v_world = v_normal = v_emission = vec3(0.0);
  v_albedo = vec4(0.0);
  const uint index = gl_InstanceIndex;
  const Particle p = particles[slot_of(drawn, index)];
  const uint age = age_of(p);
  if (age == kDeadAge || generation_of(p) > 0u || is_bad(p)) return;
  const EmitterData e = emitters[drawn.emitter];
  const uint key = particle_key(e, drawn.first + index), face = gl_VertexIndex / 3u, corner = gl_VertexIndex % 3u;
  const MeshRange mesh = mesh_ranges[mesh_of(e, key)];
  if (face >= mesh.count) return;
  const Look look = look_of(e, drawn.emitter, age, key);
  const Placed placed = placed_mesh(e, mesh, p, age, key, look.radius);
  const MeshTriangle t = mesh_triangles[mesh.first + face];
  v_world = place_corner(placed, t.corner + (corner == 0u ? vec3(0.0) : corner == 1u ? t.edge_u : t.edge_v));
  v_normal = normalize(rotated(placed.rotation, cross(t.edge_u, t.edge_v)));
  const float shade = 0.75 + 0.5 * random(key, 37u);   // no piece has quite the colour of another
  const bool lit = (e.flags & kEmitterLit) != 0u;
  v_albedo = vec4(curve(drawn.emitter, 1u, look.life).rgb * (lit ? shade : 1.0), lit ? 1.0 : 0.0);
  v_emission = curve(drawn.emitter, 2u, look.life).rgb;
  gl_Position = view.view_projection * vec4(v_world, 1.0);
}
