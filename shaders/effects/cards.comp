// Particles to cards: what a particle looks like at this tick from this camera. Camera-facing, or stretched along its velocity.
//   tau = C / (pi r^2) * fade   (physical: growth thins)   or   tau = -ln(1 - alpha) * fade   (the artist's curve)
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/features.glsl"
#include "effects/noise.glsl"
#include "effects/particle.glsl"
#include "effects/puff.h"
#include "effects/spans.glsl"
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/view.h"

layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer Particles { Particle particles[]; };
layout(scalar, binding = 4) uniform View { ViewData view; };
layout(scalar, binding = 5) readonly buffer Curves { vec4 curves[]; };
layout(scalar, binding = 6) writeonly buffer Cards { Card cards[]; };
layout(push_constant) uniform Push {
  uint threads;
  uint first_span;
  uint span_count;
  uint first_card;
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

// The cloud as a whole is lit too: (share of the sun, share of the sky) that reaches a particle through the others. Clouds are
// about as large as a few of their puffs: towards the sun from the middle it is bright, beyond it dark, near the ground dim.
vec2 cloud_light(EmitterData e, vec3 position, float radius, uint age) {
  const vec3 middle = e.core + 0.5 * float(age) * kTick * e.wind;   // the wind bends it
  const vec3 arm = (position - middle) / (1.5 * radius);
  return vec2(0.1 + 0.9 * smoothstep(-0.7, 1.3, dot(arm, view.sun_direction)), 0.5 + 0.5 * smoothstep(0.0, 1.5, arm.y));
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

// Curl noise may displace what is drawn, and nothing else: the state stays where forces brought it.
vec3 displacement(EmitterData e, vec3 position, uint age, uint tick) {
  const float drift = e.displacement_speed * float(tick) * kTick;
  const float grown = min(float(age) * e.displacement_per_tick, 1.0);
  return turbulence(e.seed, position - e.origin, e.displacement_inv_m, drift, e.displacement_m * grown, e.displacement_octaves);
}

// `tick` is the emitter's.
Card card_of(EmitterData e, uint emitter, Particle p, uint age, uint key, uint tick) {
  if ((kFeatures & kUsesDisplacement) != 0u) p.position += displacement(e, p.position, age, tick);
  const uint life_ticks = life_of(e, key);
  const float life = float(age) / float(life_ticks);
  const vec4 shape = curve(emitter, 0u, life);   // radius, fade, alpha
  const float radius = shape.x * mix(e.radius_scale_min, e.radius_scale_max, random(key, 22u));
  float tau = e.cross_section > 0.0 ? e.cross_section / (3.14159265 * radius * radius)
                                    : min(-log(max(1.0 - shape.z, 1e-28)), kOpaqueDepth);
  tau *= shape.y;

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
  const vec3 color = curve(emitter, 1u, life).rgb;
  const vec3 sky = mix(view.horizon, view.zenith, 0.6);   // more of the sky is above than beside
  const vec2 reached = cloud_light(e, p.position, radius, age);
  float blend;
  const uint layers = layers_of(e, key, age, blend);
  Card card;
  card.center = view.camera + ray * scale;
  card.optical_depth = tau;
  card.axis_u = u * scale;
  card.inv_feather = e.inv_feather;
  card.axis_v = v * scale;
  card.layers = layers | ((e.flags & kEmitterSetApart) != 0u ? kCardSetApart : 0u);
  card.sunlit = pack_half4(vec4(lit ? color * view.sun_color * reached.x : vec3(0.0), blend));
  card.ambient = pack_half4(vec4(lit ? color * sky * reached.y : color, 0.0));
  card.emission = pack_half4(vec4(curve(emitter, 2u, life).rgb * shape.y, 0.0));
  card.transmission = pack_half4(vec4(e.transmission, e.diffusion));
  card.light = pack_half4(vec4(dot(view.sun_direction, normalize(u)), dot(view.sun_direction, normalize(v)),
                               -dot(view.sun_direction, view.forward), 0.0));
  card.motion = pack_half4(vec4(p.velocity * (kTick * scale), e.distortion * shape.y));
  return card;
}

void main() {
  const uint thread = gl_GlobalInvocationID.x;
  if (thread >= threads) return;
  const Span span = span_of(thread, first_span, span_count);
  const uint index = thread - span.offset, birth = span.first + index;
  const Particle p = particles[slot_of(span, index)];
  const EmitterData e = emitters[span.emitter];
  const uint age = age_of(p);
  if (age == kDeadAge || generation_of(p) > 0u) cards[first_card + thread] = hidden_card();
  else cards[first_card + thread] = card_of(e, span.emitter, p, age, particle_key(e, birth), span.tick);
}
