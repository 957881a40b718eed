// Puff textures, step 2: one work group a layer. Scales optical depth so that its mean over the card's inscribed disc is 1 (that is what
// alpha = 1 - exp(-C / (pi r^2)) speaks of), and turns the height into a normal and an openness.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "effects/puff.h"
#include "surface/texture_depth.h"

layout(local_size_x = 16, local_size_y = 16) in;
layout(scalar, binding = 0) readonly buffer March { vec2 march[]; };
layout(binding = 1, rgba8) writeonly uniform image2DArray puffs;

shared float sums[256];

float height_at(ivec2 p, uint layer) {
  const uvec2 q = uvec2(clamp(p, ivec2(0), ivec2(kPuffSize - 1u)));
  return march[(layer * kPuffSize + q.y) * kPuffSize + q.x].y;
}

vec4 puff_texel(ivec2 p, vec2 uv, uint layer, float mean) {
  const float tau = march[(layer * kPuffSize + uint(p.y)) * kPuffSize + uint(p.x)].x;
  float around = 0.0;
  for (int y = -6; y <= 6; y += 3)
    for (int x = -6; x <= 6; x += 3) around += height_at(p + ivec2(x, y), layer) / 25.0;
  const float texels = float(kPuffSize) * 0.5;   // per radius
  const vec2 slope = vec2(height_at(p + ivec2(2, 0), layer) - height_at(p - ivec2(2, 0), layer),
                          height_at(p + ivec2(0, 2), layer) - height_at(p - ivec2(0, 2), layer)) * (texels / 4.0);
  const vec3 bump = normalize(vec3(-slope, 1.2));
  const vec3 sphere = vec3(uv, sqrt(max(1.0 - dot(uv, uv), 0.0)));
  const vec3 normal = normalize(mix(sphere, bump, 0.75));
  const float openness = clamp(kMeanOpenness + 2.0 * (height_at(p, layer) - around), 0.35, 1.0);
  return vec4(tau / mean / kTextureDepth, normal.xy * 0.5 + 0.5, openness);
}

vec4 plain_texel(vec2 uv, uint layer) {
  const float r2 = dot(uv, uv);
  float density = 1.0;                                              // solid
  if (layer == kDiscLayer) density = 1.15 * (1.0 - smoothstep(0.75, 1.0, sqrt(r2)));
  if (layer == kSoftLayer) density = 3.0 * max(1.0 - r2, 0.0) * max(1.0 - r2, 0.0);
  if (layer == kBandLayer) density = 1.875 * (1.0 - uv.y * uv.y) * (1.0 - uv.y * uv.y);
  return vec4(density / kTextureDepth, 0.5, 0.5, 1.0);
}

void main() {
  const uint layer = gl_WorkGroupID.z, thread = gl_LocalInvocationIndex;
  const uint texels = kPuffSize * kPuffSize;
  float sum = 0.0;
  if (layer < kDiscLayer)
    for (uint i = thread; i < texels; i += 256u) sum += march[layer * texels + i].x;
  sums[thread] = sum;
  for (uint step = 128u; step > 0u; step /= 2u) {
    barrier();
    if (thread < step) sums[thread] += sums[thread + step];
  }
  barrier();
  const float mean = sums[0] / (float(texels) * 3.14159265 / 4.0);
  for (uint i = thread; i < texels; i += 256u) {
    const ivec2 p = ivec2(i % kPuffSize, i / kPuffSize);
    const vec2 uv = (vec2(p) + 0.5) / float(kPuffSize) * 2.0 - 1.0;
    imageStore(puffs, ivec3(p, layer), layer < kDiscLayer ? puff_texel(p, uv, layer, mean) : plain_texel(uv, layer));
  }
}
