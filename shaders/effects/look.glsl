// What a particle's age says of its looks, whatever it is made of: a puff, a mesh, a piece of a ribbon.
//   tau = C / (pi r^2) * fade   (physical: growth thins)   or   tau = -ln(1 - alpha) * fade   (the artist's curve)
#ifndef PLUME_EFFECTS_LOOK_GLSL
#define PLUME_EFFECTS_LOOK_GLSL
#include "effects/particle.glsl"
#include "effects/puff.h"
#include "effects/sky_light.glsl"
#include "shared/card.h"
#include "shared/half.glsl"
#include "shared/light.h"
#include "shared/view.h"

layout(scalar, binding = 5) readonly buffer Curves { vec4 curves[]; };

vec4 curve(uint emitter, uint row, float life) {
  const float at = clamp(life, 0.0, 1.0) * float(kCurveSamples - 1u);
  const uint i = min(uint(at), kCurveSamples - 2u);
  const uint base = (emitter * kCurvesPerEmitter + row) * kCurveSamples + i;
  return mix(curves[base], curves[base + 1u], at - float(i));
}

struct Look {
  float life;            // share of it that is over
  float radius;          // m
  float fade;
  float optical_depth;   // of the texture's mean
};

Look look_of(EmitterData e, uint emitter, uint age, uint key) {
  Look look;
  look.life = float(age) / float(life_of(e, key));
  const vec4 shape = curve(emitter, 0u, look.life);   // radius, fade, alpha
  look.radius = shape.x * mix(e.radius_scale_min, e.radius_scale_max, random(key, 22u));
  look.fade = shape.y;
  const float tau = e.cross_section > 0.0 ? e.cross_section / (3.14159265 * look.radius * look.radius)
                                          : min(-log(max(1.0 - shape.z, 1e-28)), kOpaqueDepth);
  look.optical_depth = shape.y > 0.0 ? tau * shape.y : 0.0;   // a puff of no radius is infinitely dense
  return look;
}

Card hidden_card() {
  return Card(vec3(0.0), 0.0, vec3(0.0), 0.0, vec3(0.0), 0u, uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u), uvec2(0u));
}

// In the place of a card that cannot be drawn: surface/seen_keys.comp counts it. One a particle.
Card bad_card() {
  Card card = hidden_card();
  card.optical_depth = uintBitsToFloat(0x7FC00000u);
  return card;
}

// Camera offset: along the ray with its size on screen kept; never through the near plane.
float offset_scale(EmitterData e, float depth, float near_m) {
  return clamp((depth - e.camera_offset) / depth, 2.0 * near_m / depth, 1e3);
}

// What is left of a card near the camera. Its width on the screen grows as 1 / distance, its share of light falls as much.
float near_share(EmitterData e, vec3 place, ViewData view) {
  return e.inv_near_fade > 0.0 ? min(distance(place, view.camera) * e.inv_near_fade, 1.0) : 1.0;
}

// In the full light of sun and sky: see effects/light_cards.comp for what is left of it. Sets the layer flag too, and thins what is near:
// centre and optical depth come first.
void set_colors(inout Card card, EmitterData e, uint emitter, Look look, ViewData view, float blend) {
  const bool lit = (e.flags & kEmitterLit) != 0u;
  const vec3 color = curve(emitter, 1u, look.life).rgb;
  const float share = near_share(e, card.center, view);
  card.optical_depth *= share;
  card.inv_feather = e.inv_feather;
  card.layers |= (e.flags & kEmitterSetApart) != 0u ? kCardSetApart : 0u;
  card.sunlit = pack_half4(vec4(lit ? color * view.sun_color : vec3(0.0), blend));
  card.ambient = pack_half4(vec4(lit ? color * sky_light(view) : color, 0.0));
  card.emission = pack_half4(vec4(curve(emitter, 2u, look.life).rgb * (look.fade * share), 0.0));
  card.transmission = pack_half4(vec4(e.transmission, e.diffusion));
}

LitBody dark_body() { return LitBody(vec3(0.0), 0.0, vec3(0.0), 0.0, uvec2(0u)); }

// What light falls on and comes from: sums over all of them must not meet a bad one.
LitBody unless_bad(LitBody body) {
  const bool bad = is_bad(body.position) || is_bad(body.radius) || is_bad(body.power.r + body.power.g + body.power.b) || is_bad(body.depth);
  return bad ? dark_body() : body;
}

// What light falls on and comes from, but nothing is in the shadow of. `area_m2` is what is seen of it on average.
LitBody thin_body(EmitterData e, uint emitter, Look look, vec3 position, float area_m2) {
  LitBody body;
  body.position = position;
  body.radius = look.radius;
  body.power = curve(emitter, 2u, look.life).rgb * (look.fade * area_m2 / 3.14159265);
  body.depth = 0.0;
  body.albedo = pack_half4(vec4(curve(emitter, 1u, look.life).rgb, (e.flags & kEmitterLit) != 0u ? 1.0 : 0.0));
  return body;
}

#endif
