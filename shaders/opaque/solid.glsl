// Solids in the light of lighting.glsl. Materials are procedural.
#ifndef PLUME_OPAQUE_SOLID_GLSL
#define PLUME_OPAQUE_SOLID_GLSL
#include "opaque/lighting.glsl"
#include "shared/hash.h"

layout(location = 0) in vec3 v_world;
layout(location = 1) in vec3 v_normal;
layout(location = 2) flat in uint v_solid;
layout(location = 0) out vec4 color;

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

void main() {
  const SolidData s = solids[v_solid];
  if (s.material == kMaterialUnlit) {
    color = vec4(s.color, 1.0);
    return;
  }
  const vec3 normal = normalize(v_normal);
  const float offset_m = s.kind >= kSolidSphere ? 0.04 + 0.15 * s.radius : 0.01;   // meshes lie inside their round bodies
  color = vec4(albedo(s, normal) * light_on(v_world, normal, offset_m), 1.0);
}

#endif
