// Consecutive births of an emitter joined to a ribbon that turns its face to the camera: two triangles a segment, whose corners at a
// joint are the same for both segments that meet there. Across the joint P of segments with directions d0 and d1, as seen from the
// camera, lies the mitre
//   n = across(d0 + d1) / |..|,   half width = r / cos(half the bend)     r: of the particle there
// no longer than kLongestMitre r. What has no length on the screen gives nothing, and the ribbon ends there.
//   tau = C / (2 r length) * fade   (physical: growth and stretching thin)   or the artist's curve
// The children of one parent are a ribbon of their own. The next of them that is to be born is its head: until then its slot carries the
// parent, so that a trail begins where the parent is.
// Limits: a ribbon wider than its bend is round folds over itself; optical depth and colour are even over a segment; births of one tick
// and one place (more than 60 a second from a point) have no segment between them, so that those around it meet without a mitre.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/displacement.glsl"
#include "effects/look.glsl"
#include "effects/state.glsl"

layout(local_size_x = 64) in;
layout(scalar, binding = 14) uniform View { ViewData view; };
layout(scalar, binding = 6) writeonly buffer Cards { Card cards[]; };
layout(scalar, binding = 9) writeonly buffer Bodies { LitBody bodies[]; };   // for kBodies
layout(constant_id = 1) const uint kBodies = 0u;   // light asks what is there
layout(push_constant) uniform Push {
  uint threads;   // segments
  uint first_group;
  uint first_card;
  uint first_body;
};

const float kLongestMitre = 2.5;
const float kLeastLength = 1e-5;   // of a segment on the screen, in depths

struct Node {
  bool there;
  bool bad;   // it would be
  vec3 world;
  vec3 place;   // after the camera offset, which scales by:
  float scale;
  vec3 velocity;
  Look look;
};

// Whether births `index` and the next are of one ribbon.
bool joined(Span span, EmitterData e, int index) { return e.strand_births == 0u || (span.first + uint(index + 1)) % e.strand_births != 0u; }

// Whether `index`, who is not born yet, is the first of its ribbon of whom that is so.
bool is_head(Span span, EmitterData e, int index) {
  return index > 0 && joined(span, e, index - 1) && generation_of(particle_at(span, uint(index - 1))) == 0u;
}

Node node_at(Span span, EmitterData e, int index) {
  Node node;
  node.there = node.bad = false;
  if (index < 0 || index >= int(span.count)) return node;
  Particle p = particle_at(span, uint(index));
  uint age = age_of(p);
  if (age == kDeadAge || generation_of(p) > 1u) return node;
  if (generation_of(p) == 1u) {
    if (!is_head(span, e, index)) return node;
    age = 0u;
  }
  node.bad = is_bad(p);
  if (node.bad) return node;
  p.position = displaced(e, p.position, age, span.tick);
  const float depth = dot(p.position - view.camera, view.forward);
  node.there = depth > view.near_m;
  if (!node.there) return node;
  const float scale = offset_scale(e, depth, view.near_m);
  node.place = view.camera + (p.position - view.camera) * scale;
  node.velocity = p.velocity * scale;
  node.look = look_of(e, span.emitter, age, particle_key(e, span.first + uint(index)));
  node.look.radius *= scale;
  node.scale = scale;
  node.world = p.position;
  return node;
}

// Across a segment as seen from a point of it, unit length; 0: no length is seen.
vec3 across(vec3 from, vec3 to, vec3 seen_from) {
  const vec3 arm = cross(to - from, seen_from), eye = seen_from;
  const float size = length(arm);
  return size > kLeastLength * dot(eye, eye) ? arm / size : vec3(0.0);
}

// From the middle of the ribbon to its edge at `here`; 0: there is none.
vec3 mitre(Node before, Node here, Node after) {
  const vec3 eye = view.camera - here.place;
  const vec3 a = before.there ? across(before.place, here.place, eye) : vec3(0.0);
  const vec3 b = after.there ? across(here.place, after.place, eye) : vec3(0.0);
  if (a == vec3(0.0) || b == vec3(0.0)) return (a + b) * here.look.radius;
  const vec3 sum = a + b;
  const float size = length(sum);   // twice the cosine of half the bend
  if (size < 1e-4) return a * here.look.radius;   // straight back
  return sum * (here.look.radius / size * min(2.0 / size, kLongestMitre));
}

Card half_of(vec3 corner, vec3 to_u, vec3 to_v) {
  Card card;
  card.center = 0.5 * (to_u + to_v);
  card.axis_u = 0.5 * (to_u - corner);
  card.axis_v = 0.5 * (to_v - corner);
  return card;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_group);
  const EmitterData e = emitters[span.emitter];
  const int index = int(thread - span.offset);
  const uint at = first_card + 2u * thread;
  cards[at] = hidden_card();
  cards[at + 1u] = hidden_card();
  if (kBodies != 0u) for (uint i = 0u; i < 2u; ++i) bodies[first_body + 2u * thread + i] = dark_body();
  const Node a = node_at(span, e, index), b = node_at(span, e, index + 1);
  if (a.bad) cards[at] = bad_card();
  if (!a.there || !b.there || !joined(span, e, index)) return;
  Node before = node_at(span, e, index - 1), after = node_at(span, e, index + 2);
  before.there = before.there && joined(span, e, index - 1);
  after.there = after.there && joined(span, e, index + 1);
  const vec3 own = across(a.place, b.place, view.camera - a.place);
  vec3 from = mitre(before, a, b), to = mitre(a, b, after);
  if (own == vec3(0.0) || from == vec3(0.0) || to == vec3(0.0)) return;
  from *= dot(from, own) < 0.0 ? -1.0 : 1.0;   // where it turns straight back
  to *= dot(to, own) < 0.0 ? -1.0 : 1.0;

  Look look;
  look.life = 0.5 * (a.look.life + b.look.life);
  look.radius = 0.5 * (a.look.radius + b.look.radius);
  look.fade = 0.5 * (a.look.fade + b.look.fade);
  look.optical_depth = e.cross_section > 0.0 ? look.fade * e.cross_section / (2.0 * look.radius * length(b.place - a.place))
                                             : 0.5 * (a.look.optical_depth + b.look.optical_depth);
  const vec3 to_eye = normalize(view.camera - a.place);
  Card halves[2] = Card[](half_of(a.place + from, b.place + to, a.place - from), half_of(b.place - to, a.place - from, b.place + to));
  for (uint i = 0u; i < 2u; ++i) {
    Card card = halves[i];
    const uint layer = e.texture_kind == kTextureSolid ? kSolidLayer : kBandLayer;
    card.optical_depth = min(look.optical_depth, kOpaqueDepth);
    card.layers = layer | layer << kLayerBits | kCardTriangle;
    set_colors(card, e, span.emitter, look, view, 0.0);
    card.light = pack_half4(vec4(0.0, 0.0, dot(view.sun_direction, to_eye), 0.0));
    card.motion = pack_half4(vec4(0.5 * (a.velocity + b.velocity) * kTick, 0.0));
    cards[at + i] = card;
  }
  if (kBodies == 0u) return;
  Look seen = look;
  seen.radius = 0.5 * (a.look.radius / a.scale + b.look.radius / b.scale);
  const float half_area = 0.785398 * seen.radius * distance(a.world, b.world);   // of a band that turns to the eye, as a tube
  const LitBody body = unless_bad(thin_body(e, span.emitter, seen, 0.5 * (a.world + b.world), half_area));
  for (uint i = 0u; i < 2u; ++i) bodies[first_body + 2u * thread + i] = body;
}
