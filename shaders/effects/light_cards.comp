// Light on cards: what of the sun and of the sky is left behind the others, and what fires add. The particle's own share of the optical
// depth is taken out: a puff's texture shades the puff (shaders/surface/shading.glsl), the volume shades the cloud.
// A card has one direction of light: the mean over all that arrives, weighted by luminance. Where that is spread, the mean is short and
// the card evenly lit.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "effects/light_volume.glsl"
#include "effects/sky_light.glsl"
#include "shared/half.glsl"
#include "shared/view.h"
#include "surface/seen_cards.glsl"

layout(local_size_x = kItemGroup) in;
layout(constant_id = 0) const uint kShadowed = 1u;   // something casts
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 8) readonly buffer Bodies { LitBody bodies[]; };
layout(scalar, binding = 1) buffer Cards { Card cards[]; };
layout(push_constant) uniform Push {
  uint first_card;   // of those with a body
  uint body_count;
};

const vec3 kLuminance = vec3(0.2126, 0.7152, 0.0722);
const int kSteps = 6;

// Optical depth between a body and the edge of a fire. In the body itself the volume is at its densest: 9/32 of all per square radius.
float depth_to(FireLight fire, LitBody body, vec3 towards) {
  const LightGrid grid = grids[0];
  const float reach = max(distance(fire.position, body.position) - fire.radius, 0.0), step = reach / float(kSteps);
  float extinction = 0.0;
  for (int i = 0; i < kSteps; ++i)
    extinction += textureLod(sun_volume, volume_uv(grid, body.position + towards * (step * (float(i) + 0.5))), 0.0).g;
  const vec3 half_width = spread(grid, body);
  const float own = cell_depth(grid, body, half_width) * (9.0 / 32.0) / (half_width.x * half_width.y);
  return max(extinction * step - own * min(reach / max(body.radius, 1e-3), 1.0), 0.0);
}

// Irradiance / pi, and its mean direction times its luminance.
struct Directed {
  vec3 light;
  vec3 mean;
};

void add(inout Directed sum, vec3 light, vec3 towards, vec3 albedo, float tau) {
  const vec3 arriving = light * (direct_share(tau) + albedo * scattered_share(tau));
  sum.light += arriving;
  sum.mean += towards * dot(arriving, kLuminance);
}

// A card as a plane that light falls on: sprites turn to the camera as a whole, triangles are seen from both sides.
vec3 towards_eye(Card card) {
  if ((card.layers & kCardTriangle) == 0u) return -view.forward;
  const vec3 normal = normalize(cross(card.axis_u, card.axis_v));
  return dot(normal, view.camera - card.center) < 0.0 ? -normal : normal;
}

void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i >= work.count) return;
  const uint id = order[i], own = id - first_card;
  if (own >= body_count) return;
  const LitBody body = bodies[own];
  const vec4 albedo = unpack_half4(body.albedo);
  const Card card = cards[id];
  if (albedo.a == 0.0 || card.axis_u == vec3(0.0)) return;   // unlit, or behind the camera
  float sun_tau = 0.0, sky_tau = 0.0;
  if (kShadowed != 0u) {
    sun_tau = max(sun_depth(body.position) - own_depth(grids[0], body), 0.0);
    sky_tau = max(sky_depth(body.position) - own_depth(grids[1], body), 0.0);
  }
  Directed sum = Directed(vec3(0.0), vec3(0.0));
  add(sum, view.sun_color, view.sun_direction, albedo.rgb, sun_tau);
  for (uint f = 0u; f < fire_count; ++f) {
    vec3 to_fire;
    const vec3 light = fire_light(fires[f], body.position, to_fire);
    add(sum, light, to_fire, albedo.rgb, kShadowed != 0u ? depth_to(fires[f], body, to_fire) : 0.0);
  }
  const vec3 towards = sum.mean / max(dot(sum.light, kLuminance), 1e-6);
  const float blend = unpack_half4(card.sunlit).a;
  cards[id].sunlit = pack_half4(vec4(albedo.rgb * sum.light, blend));
  cards[id].ambient = pack_half4(vec4(albedo.rgb * sky_light(view) * total_share(sky_tau), 0.0));
  cards[id].light = pack_half4(
      vec4(dot(towards, normalize(card.axis_u)), dot(towards, normalize(card.axis_v)), dot(towards, towards_eye(card)), 0.0));
}
