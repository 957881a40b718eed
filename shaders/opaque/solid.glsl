// Solids lit by the sun, with exact shadows against the analytic bodies, and by the sky. Materials are procedural.
// Whoever includes this says what else there is on the way of light.
#ifndef PLUME_OPAQUE_SOLID_GLSL
#define PLUME_OPAQUE_SOLID_GLSL
#include "shared/hash.h"
#include "shared/solid.h"
#include "shared/view.h"

layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Solids { SolidData solids[]; };

layout(location = 0) in vec3 v_world;
layout(location = 1) in vec3 v_normal;
layout(location = 2) flat in uint v_solid;
layout(location = 0) out vec4 color;

struct Reached {
  float sun;    // share of it that reaches a place
  float sky;
  vec3 added;   // irradiance / pi from other lights on a surface there
};
Reached reached(vec3 world, vec3 normal);

float noise(vec2 p) {
  const vec2 base = floor(p), f = p - base, u = f * f * (3.0 - 2.0 * f);
  const uvec2 q = uvec2(ivec2(base));
  vec4 c;
  for (uint i = 0u; i < 4u; ++i)
    c[i] = float(hash(q.x + (i & 1u) + hash(q.y + (i >> 1u))) >> 8u) * (1.0 / 16777216.0);
  return mix(mix(c.x, c.y, u.x), mix(c.z, c.w, u.x), u.y);
}

float fractal(vec2 p) { return 0.5 * noise(p) + 0.3 * noise(p * 2.3 + 7.0) + 0.2 * noise(p * 5.1 + 3.0); }

// Coordinates on the surface, metres: along the wall and up it, or on the ground.
vec2 surface_uv(vec3 normal) {
  if (abs(normal.y) > 0.7) return v_world.xz;
  return vec2(dot(v_world.xz, normalize(vec2(-normal.z, normal.x))), v_world.y);
}

vec3 brick(vec3 base, vec2 uv) {
  const vec2 size = vec2(0.46, 0.16);
  const float row = floor(uv.y / size.y);
  const vec2 cell = vec2(uv.x / size.x + 0.5 * mod(row, 2.0), uv.y / size.y);
  const vec2 f = fract(cell), width = 1.6 * fwidth(cell) + vec2(0.03, 0.08);
  const float mortar = max(1.0 - smoothstep(0.0, width.x, min(f.x, 1.0 - f.x)), 1.0 - smoothstep(0.0, width.y, min(f.y, 1.0 - f.y)));
  const float shade = 0.7 + 0.6 * float(hash(uint(int(floor(cell.x))) + hash(uint(int(row)))) >> 24u) / 255.0;
  return mix(base * shade, 0.5 * base + vec3(0.17, 0.16, 0.15), 0.6 * mortar);
}

// A road: grains, darker patches, and worn dashed lines a lane (3.5 m) apart along x. What is finer than a pixel is left out.
vec3 asphalt(vec3 base, vec2 uv) {
  const vec2 pixel = fwidth(uv);
  const float grains = (noise(uv * 37.0) - 0.5) * clamp(1.5 - 37.0 * max(pixel.x, pixel.y), 0.0, 1.0);
  const float patches = smoothstep(0.55, 0.7, noise(uv * vec2(0.22, 0.5) + 11.0));
  const vec3 road = base * (0.65 + 0.5 * fractal(uv * 0.6) + 0.6 * grains) * (1.0 - 0.35 * patches);
  const vec2 spacing = vec2(4.0, 3.5), half_size = vec2(1.0, 0.06);   // of the dashes, m
  const vec2 outside = abs(uv - spacing * round(uv / spacing)) - half_size, soft = pixel + 0.01;
  const vec2 inside = 1.0 - smoothstep(-soft, soft, outside);
  const float worn = smoothstep(0.25, 0.55, fractal(uv * 4.0 + 5.0));
  return mix(road, vec3(0.5, 0.49, 0.46), 0.75 * worn * inside.x * inside.y);
}

// Planks 0.18 m wide, each of its own shade, with grain along them and dark gaps between.
vec3 wood(vec3 base, vec2 uv) {
  const float plank = uv.y / 0.18, soft = fwidth(plank);
  const float edge = min(fract(plank), 1.0 - fract(plank));
  const float grain = noise(vec2(uv.x * 1.3 + 9.0 * floor(plank), uv.y * 45.0));
  return base * (0.6 + 0.4 * grain + 0.4 * noise(vec2(floor(plank), 3.0))) * (1.0 - 0.7 * (1.0 - smoothstep(0.02, 0.04 + soft, edge)));
}

vec3 albedo(SolidData s, vec3 normal) {
  const vec2 uv = surface_uv(normal);
  switch (s.material) {
    case 1u: return asphalt(s.color, uv);
    case 2u: return brick(s.color, uv);
    case 3u: return wood(s.color, uv);
    case 4u: return s.color * (0.75 + 0.4 * fractal(uv * 1.4) + 0.1 * (noise(uv * 31.0) - 0.5));                  // concrete
    default: return s.color;
  }
}

bool hits_box(SolidData s, vec3 origin, vec3 direction) {
  const vec3 local = origin - s.position;
  const vec3 o = vec3(local.x * s.yaw_cos - local.z * s.yaw_sin, local.y, local.z * s.yaw_cos + local.x * s.yaw_sin);
  const vec3 d = vec3(direction.x * s.yaw_cos - direction.z * s.yaw_sin, direction.y, direction.z * s.yaw_cos + direction.x * s.yaw_sin);
  const vec3 a = (-s.half_size - o) / d, b = (s.half_size - o) / d;
  const vec3 enter = min(a, b), leave = max(a, b);
  return max(max(enter.x, enter.y), max(enter.z, 0.0)) < min(leave.x, min(leave.y, leave.z));
}

// Least distance between the ray and the capsule's core, against its radius.
bool hits_capsule(SolidData s, vec3 origin, vec3 direction) {
  const vec3 core = s.end - s.position, gap = origin - s.position;
  const float cc = max(dot(core, core), 1e-12), cd = dot(core, direction), cg = dot(core, gap), dg = dot(direction, gap);
  const float denominator = max(cc - cd * cd, 1e-12);
  float along = clamp((cg - cd * dg) / denominator, 0.0, 1.0);
  float t = along * cd - dg;
  if (t < 0.0) {
    t = 0.0;
    along = clamp(cg / cc, 0.0, 1.0);
  }
  const vec3 between = gap + direction * t - core * along;
  return dot(between, between) < s.radius * s.radius;
}

float sunlight(vec3 origin) {
  for (uint i = 0u; i < view.solid_count; ++i) {
    const SolidData s = solids[i];
    if (s.kind == kSolidPlane) continue;
    const bool hit = s.kind == kSolidBox ? hits_box(s, origin, view.sun_direction) : hits_capsule(s, origin, view.sun_direction);
    if (hit) return 0.0;
  }
  return 1.0;
}

void main() {
  const SolidData s = solids[v_solid];
  if (s.material == kMaterialUnlit) {
    color = vec4(s.color, 1.0);
    return;
  }
  const vec3 normal = normalize(v_normal);
  const float facing = max(dot(normal, view.sun_direction), 0.0);
  const vec3 offset = normal * (s.kind >= kSolidSphere ? 0.04 + 0.15 * s.radius : 0.01);   // meshes lie inside their round bodies
  const Reached light = reached(v_world, normal);
  const vec3 sun = light.sun * view.sun_color * facing * (facing > 0.0 ? sunlight(v_world + offset) : 0.0);
  const vec3 sky = mix(view.horizon * 0.45, view.zenith * 0.6 + view.horizon * 0.35, normal.y * 0.5 + 0.5);
  const float contact = 1.0 - 0.45 * exp(-3.0 * max(v_world.y, 0.0)) * (1.0 - abs(normal.y));   // darker where walls meet ground
  color = vec4(albedo(s, normal) * (sun + light.sky * sky * contact + light.added), 1.0);
}

#endif
