// Particles to cards: what a particle looks like at this tick from this camera. Camera-facing, or stretched along its velocity.
// Cards stand in the full light of sun and sky: see effects/light_cards.comp for what is left of it.
//   tau = C / (pi r^2) * fade   (physical: growth thins)   or   tau = -ln(1 - alpha) * fade   (the artist's curve)
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/features.glsl"
#include "effects/noise.glsl"
#include "effects/particle.glsl"
#include "effects/puff.h"
#include "effects/sky_light.glsl"
#include "effects/spans.glsl"
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/light.h"
#include "shared/view.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Particles { Particle particles[]; };
layout(scalar, binding = 4) uniform View { ViewData view; };
layout(scalar, binding = 5) readonly buffer Curves { vec4 curves[]; };
layout(scalar, binding = 6) writeonly buffer Cards { Card cards[]; };
layout(scalar, binding = 7) writeonly buffer Bodies { LitBody bodies[]; };   // for kBodies
layout(constant_id = 1) const uint kBodies = 0u;   // light asks what is there
layout(push_constant) uniform Push {
  uint threads;
  uint first_span;
  uint span_count;
  uint first_card;
  uint first_body;
};

vec4 curve(uint emitter, uint row, float life) {
  const float at = clamp(life, 0.0, 1.0) * float(kCurveSamples - 1u);
  const uint i = min(uint(at), kCurveSamples - 2u);
  const uint base = (emitter * kCurvesPerEmitter + row) * kCurveSamples + i;
  return mix(curves[base], curves[base + 1u], at - float(i));
}

Card hidden_card() {
  return Card(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0u, uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u));
}

uint layers_of(EmitterData e, uint key, uint age, out float blend) {
  blend = 0.0;
  if (e.texture_kind != kTexturePuff) {
    const uint layer = e.texture_kind == kTextureDisc ? kDiscLayer : kSoftLayer;
    return layer | layer << kLayerBits;
  }
  const float frame = random(key, 20u) * float(kPuffFrames) + float(age) * e.frames_per_tick;
  const uint variant = hash(key + 21u) % kPuffVariants;
  const uint now = uint(frame) % kPuffFrames;
  blend = fract(frame);
  return (variant * kPuffFrames + now) | (variant * kPuffFrames + (now + 1u) % kPuffFrames) << kLayerBits;
}

// Curl noise may displace what is drawn, and nothing else: the state stays where forces brought it. `tick` is the emitter's.
vec3 displacement(EmitterData e, vec3 position, uint age, uint tick) {
  const float drift = e.displacement_speed * float(tick) * kTick;
  const float grown = min(float(age) * e.displacement_per_tick, 1.0);
  return turbulence(e.seed, position - e.origin, e.displacement_inv_m, drift, e.displacement_m * grown, e.displacement_octaves);
}

// The same from every camera.
struct Puff {
  float life;     // 0 at birth, 1 at death
  float radius;   // m
  float tau;      // optical depth, mean over its disc
  float fade;
};

Puff puff_of(EmitterData e, uint emitter, uint age, uint key) {
  const float life = float(age) / float(life_of(e, key));
  const vec4 shape = curve(emitter, 0u, life);   // radius, fade, alpha
  const float radius = shape.x * mix(e.radius_scale_min, e.radius_scale_max, random(key, 22u));
  const float tau = e.cross_section > 0.0 ? e.cross_section / (3.14159265 * radius * radius)
                                          : min(-log(max(1.0 - shape.z, 1e-28)), kOpaqueDepth);
  return Puff(life, radius, shape.y > 0.0 ? tau * shape.y : 0.0, shape.y);   // a puff of no radius is infinitely dense
}

LitBody dark_body() { return LitBody(vec3(0.0), 0.0, vec3(0.0), 0.0, uvec2(0u)); }

// A stretched card is an ellipse that is seen from the side on average: pi / 4 of its length.
LitBody body_of(EmitterData e, uint emitter, Particle p, Puff puff) {
  const float length_m = puff.radius + length(p.velocity) * e.stretch * 0.785398;
  const float gray = 1.0 - dot(e.transmission, vec3(1.0 / 3.0));
  LitBody body;
  body.position = p.position;
  body.radius = puff.radius;
  body.power = curve(emitter, 2u, puff.life).rgb * (puff.fade * puff.radius * length_m);   // pi r l of radiance, over pi
  body.depth = (e.flags & kEmitterCasts) != 0u ? puff.tau * gray : 0.0;
  body.albedo = pack_half4(vec4(curve(emitter, 1u, puff.life).rgb, (e.flags & kEmitterLit) != 0u ? 1.0 : 0.0));
  return body;
}

Card card_of(EmitterData e, uint emitter, Particle p, Puff puff, uint age, uint key) {
  const float radius = puff.radius;
  float tau = puff.tau;
  const vec3 ray = p.position - view.camera;
  const float depth = dot(ray, view.forward);
  if (depth <= view.near_m) return hidden_card();
  // Camera offset: along the ray with its size on screen kept; never through the near plane.
  const float scale = clamp((depth - e.camera_offset) / depth, 2.0 * view.near_m / depth, 1e3);
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

  const bool lit = (e.flags & kEmitterLit) != 0u;
  const vec3 color = curve(emitter, 1u, puff.life).rgb;
  float blend;
  const uint layers = layers_of(e, key, age, blend);
  Card card;
  card.center = view.camera + ray * scale;
  card.optical_depth = tau;
  card.axis_u = u * scale;
  card.inv_feather = e.inv_feather;
  card.axis_v = v * scale;
  card.layers = layers | ((e.flags & kEmitterSetApart) != 0u ? kCardSetApart : 0u);
  card.sunlit = pack_half4(vec4(lit ? color * view.sun_color : vec3(0.0), blend));
  card.ambient = pack_half4(vec4(lit ? color * sky_light(view) : color, 0.0));
  card.emission = pack_half4(vec4(curve(emitter, 2u, puff.life).rgb * puff.fade, 0.0));
  card.transmission = pack_half4(vec4(e.transmission, e.diffusion));
  card.light = pack_half4(vec4(dot(view.sun_direction, normalize(u)), dot(view.sun_direction, normalize(v)),
                               -dot(view.sun_direction, view.forward), 0.0));
  card.motion = pack_half4(vec4(p.velocity * (kTick * scale), e.distortion * puff.fade));
  return card;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_span, span_count);
  const uint index = thread - span.offset, birth = span.first + index;
  Particle p = particles[slot_of(span, index)];
  const EmitterData e = emitters[span.emitter];
  const uint age = age_of(p);
  if (age == kDeadAge || generation_of(p) > 0u) {
    cards[first_card + thread] = hidden_card();
    if (kBodies != 0u) bodies[first_body + thread] = dark_body();
    return;
  }
  if ((kFeatures & kUsesDisplacement) != 0u) p.position += displacement(e, p.position, age, span.tick);
  const uint key = particle_key(e, birth);
  const Puff puff = puff_of(e, span.emitter, age, key);
  cards[first_card + thread] = card_of(e, span.emitter, p, puff, age, key);
  if (kBodies != 0u) bodies[first_body + thread] = body_of(e, span.emitter, p, puff);
}
