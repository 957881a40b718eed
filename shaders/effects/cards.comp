// Particles to cards: what a particle looks like at this tick from this camera. Camera-facing, or stretched along its velocity.
// Cards stand in the full light of sun and sky: see effects/light_cards.comp for what is left of it.
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
  uint threads;
  uint first_group;
  uint first_card;
  uint first_body;
};

uint layers_of(EmitterData e, uint key, uint age, float life, out float blend) {
  blend = 0.0;
  if (e.texture_kind != kTexturePuff) {
    const uint layer = kDiscLayer + e.texture_kind - kTextureDisc;   // in one order
    return layer | layer << kLayerBits;
  }
  const float frame = random(key, 20u) * float(kPuffFrames) + float(age) * e.frames_per_tick + life * e.frames_a_life;
  const uint variant = hash(key + 21u) % kPuffVariants;
  const uint now = uint(frame) % kPuffFrames;
  blend = fract(frame);
  return (variant * kPuffFrames + now) | (variant * kPuffFrames + (now + 1u) % kPuffFrames) << kLayerBits;
}

// A stretched card is an ellipse that is seen from the side on average: pi / 4 of its length.
LitBody body_of(EmitterData e, uint emitter, Particle p, Look look) {
  const float length_m = look.radius + length(p.velocity) * e.stretch * 0.785398;
  const float gray = 1.0 - dot(e.transmission, vec3(1.0 / 3.0));
  LitBody body = thin_body(e, emitter, look, p.position, 3.14159265 * look.radius * length_m);
  body.depth = (e.flags & kEmitterCasts) != 0u ? look.optical_depth * gray : 0.0;
  return body;
}

Card card_of(EmitterData e, uint emitter, Particle p, Look look, uint age, uint key) {
  const float radius = look.radius;
  float tau = look.optical_depth;
  const vec3 ray = p.position - view.camera;
  const float depth = dot(ray, view.forward);
  if (depth <= view.near_m) return hidden_card();
  const float scale = offset_scale(e, depth, view.near_m);
  // Puffs that the camera enters fade instead of being cut by the near plane.
  tau *= clamp((depth - view.near_m) / max(radius, 1e-3), 0.0, 1.0);

  vec3 u, v;
  const float angle = kTwoPi * random(key, 23u) + mix(e.spin_min, e.spin_max, random(key, 24u)) * float(age) * kTick;
  u = view.right * cos(angle) + view.up * sin(angle);
  if (e.stretch > 0.0) {
    const vec2 on_screen = vec2(dot(p.velocity, view.right), dot(p.velocity, view.up));
    if (dot(on_screen, on_screen) > 1e-8) u = normalize(view.right * on_screen.x + view.up * on_screen.y);
    v = cross(view.forward, u);
    v *= radius;
    u *= radius + length(on_screen) * e.stretch;
  } else {
    v = cross(view.forward, u) * radius;
    u *= radius;
  }

  float blend;
  Card card;
  card.center = view.camera + ray * scale;
  card.optical_depth = tau;
  card.axis_u = u * scale;
  card.axis_v = v * scale;
  card.layers = layers_of(e, key, age, look.life, blend);
  set_colors(card, e, emitter, look, view, blend);
  card.light = pack_half4(vec4(dot(view.sun_direction, normalize(u)), dot(view.sun_direction, normalize(v)),
                               -dot(view.sun_direction, view.forward), 0.0));
  card.motion = pack_half4(vec4(p.velocity * (kTick * scale), e.distortion * look.fade));
  return card;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_group);
  const uint index = thread - span.offset, birth = span.first + index;
  Particle p = particle_at(span, index);
  const EmitterData e = emitters[span.emitter];
  const uint age = age_of(p);
  const bool lives = age != kDeadAge && generation_of(p) == 0u;
  if (!lives || is_bad(p)) {
    cards[first_card + thread] = lives ? bad_card() : hidden_card();
    if (kBodies != 0u) bodies[first_body + thread] = dark_body();
    return;
  }
  p.position = displaced(e, p.position, age, span.tick);
  const uint key = particle_key(e, birth);
  const Look look = look_of(e, span.emitter, age, key);
  cards[first_card + thread] = card_of(e, span.emitter, p, look, age, key);
  if (kBodies != 0u) bodies[first_body + thread] = unless_bad(body_of(e, span.emitter, p, look));
}
