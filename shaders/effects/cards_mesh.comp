// Particles that are transparent meshes to cards: a triangle a thread. Flat faces, seen from both sides alike. What is glossy mirrors
// the sky and the sun besides, by Schlick's approximation of Fresnel's equations for glass (F0 = 0.04):
//   F = F0 + (1 - F0) (1 - cos)^5
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/displacement.glsl"
#include "effects/look.glsl"
#include "effects/state.glsl"
#include "effects/tumble.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 14) uniform View { ViewData view; };
layout(scalar, binding = 6) writeonly buffer Cards { Card cards[]; };
layout(scalar, binding = 9) writeonly buffer Bodies { LitBody bodies[]; };   // for kBodies
layout(constant_id = 1) const uint kBodies = 0u;   // light asks what is there
layout(push_constant) uniform Push {
  uint threads;
  uint first_group;
  uint first_card;
  uint first_body;
};

const float kGlassF0 = 0.04;
const float kGlint = 300.0;   // exponent: how small the sun is in a face that is not quite flat

// Radiance mirrored by a face with this normal, which is on the side of the eye.
vec3 mirrored(vec3 normal, vec3 to_eye) {
  const vec3 from = reflect(-to_eye, normal);
  const float fresnel = kGlassF0 + (1.0 - kGlassF0) * pow(1.0 - clamp(dot(normal, to_eye), 0.0, 1.0), 5.0);
  const vec3 sky = mix(view.horizon * (from.y < 0.0 ? 0.4 : 1.0), view.zenith, 1.0 - exp(-3.5 * max(from.y, 0.0)));
  return fresnel * (sky + view.sun_color * (0.5 * kGlint) * pow(max(dot(from, view.sun_direction), 0.0), kGlint));
}

// World: a corner and the edges from it.
struct Face {
  vec3 corner, u, v;
};

Face face_of(Placed placed, MeshTriangle t) {
  return Face(place_corner(placed, t.corner), rotated(placed.rotation, t.edge_u * placed.scale),
              rotated(placed.rotation, t.edge_v * placed.scale));
}

// A face of a closed body is seen as a quarter of its area on average.
LitBody body_of(EmitterData e, uint emitter, Look look, Face face) {
  return thin_body(e, emitter, look, face.corner + (face.u + face.v) / 3.0, 0.125 * length(cross(face.u, face.v)));
}

Card card_of(EmitterData e, uint emitter, Particle p, Look look, Face face) {
  const float depth = dot(p.position - view.camera, view.forward);
  if (depth <= view.near_m) return hidden_card();
  const vec3 corner = face.corner, u = face.u, v = face.v;
  const vec3 to_eye = normalize(view.camera - corner);
  vec3 normal = normalize(cross(u, v));
  if (dot(normal, to_eye) < 0.0) normal = -normal;
  const float scale = offset_scale(e, depth, view.near_m);
  Card card;
  card.center = view.camera + (corner + 0.5 * (u + v) - view.camera) * scale;
  card.optical_depth = look.optical_depth;
  card.axis_u = 0.5 * scale * u;
  card.axis_v = 0.5 * scale * v;
  card.layers = kSolidLayer | kSolidLayer << kLayerBits | kCardTriangle;
  set_colors(card, e, emitter, look, view, 0.0);
  if (e.gloss > 0.0) {
    const vec3 shine = min(e.gloss * look.fade * mirrored(normal, to_eye), vec3(1e4));
    card.emission = pack_half4(vec4(unpack_half4(card.emission).rgb + shine, 0.0));
  }
  card.light = pack_half4(vec4(0.0, 0.0, dot(view.sun_direction, normal), 0.0));   // the texture is flat
  card.motion = pack_half4(vec4(p.velocity * (kTick * scale), 0.0));
  return card;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_group);
  const EmitterData e = emitters[span.emitter];
  const uint at = thread - span.offset, index = at / e.cards_each, birth = span.first + index;
  Particle p = particle_at(span, index);
  const uint age = age_of(p), key = particle_key(e, birth), triangle = at % e.cards_each;
  const MeshRange mesh = mesh_ranges[mesh_of(e, key)];
  const bool lives = age != kDeadAge && generation_of(p) == 0u, bad = is_bad(p);
  if (!lives || bad || triangle >= mesh.count) {
    cards[first_card + thread] = lives && bad && triangle == 0u ? bad_card() : hidden_card();
    if (kBodies != 0u) bodies[first_body + thread] = dark_body();
    return;
  }
  p.position = displaced(e, p.position, age, span.tick);
  const Look look = look_of(e, span.emitter, age, key);
  const Face face = face_of(placed_mesh(e, mesh, p, age, key, look.radius), mesh_triangles[mesh.first + triangle]);
  cards[first_card + thread] = card_of(e, span.emitter, p, look, face);
  if (kBodies != 0u) bodies[first_body + thread] = unless_bad(body_of(e, span.emitter, look, face));
}
