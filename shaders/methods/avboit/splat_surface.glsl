// What the splats share: the optical depth of a fragment over a cell, and where along the ray it goes.
#ifndef PLUME_AVBOIT_SPLAT_SURFACE_GLSL
#define PLUME_AVBOIT_SPLAT_SURFACE_GLSL
#include "surface/shade.glsl"
#include "shared/hash.h"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/fields.glsl"

layout(constant_id = 0) const uint kLinear = 1u;    // share between slices Z and Z + 1; 0: all into Z
layout(constant_id = 1) const uint kSamples = 1u;   // of the card's texture in a cell: 1 or 4
layout(constant_id = 2) const uint kDither = 0u;

// What an optical depth of the card lets through; written so that thick cards keep their digits.
vec3 passed_by(float optical_depth) { return v_transmission.rgb + (1.0 - v_transmission.rgb) * exp(-optical_depth); }

uint ray_index() { return uint(gl_FragCoord.y) * volume.cells.x + uint(gl_FragCoord.x); }

bool hidden() {   // behind the farthest opaque surface of the cell
  const float here = texelFetch(opaque_depth, ivec2(gl_FragCoord.xy), 0).r;
  return v_uv_depth.z * here > view.near_m;
}

// Mean over the cell's samples of the texture's density; outside the card there is none.
float cell_density() {
  if (kSamples == 1u) return density(puff_texel());
  const vec2 across = dFdx(v_uv_depth.xy) * 0.25, upright = dFdy(v_uv_depth.xy) * 0.25;
  float sum = 0.0;
  for (uint i = 0u; i < 4u; ++i) {
    const vec2 place = v_uv_depth.xy + across * ((i & 1u) == 0u ? -1.0 : 1.0) + upright * ((i & 2u) == 0u ? -1.0 : 1.0);
    const vec2 uv = place * 0.5 + 0.5;
    const float inside = all(lessThanEqual(abs(place), vec2(1.0))) ? 1.0 : 0.0;
    const float a = textureLod(puffs, vec3(uv, float(v_layers_id.x)), 0.0).r, b = textureLod(puffs, vec3(uv, float(v_layers_id.y)), 0.0).r;
    sum += inside * mix(a, b, v_sunlit.a);
  }
  return 0.25 * sum * kTextureDepth * feather();
}

struct Place {
  uint slice;
  float beyond;   // share that goes to slice + 1
};

Place place_of(float depth) {
  const float position = slice_at(depth);
  const uint slice = min(uint(position), volume.slices - 1u);
  return Place(slice, kLinear == 0u || slice + 1u == volume.slices ? 0.0 : position - float(slice));
}

float rounding(uint salt) {
  if (kDither == 0u) return 0.5;
  return float(hash_pair(hash_pair(v_layers_id.z, ray_index()), view.tick * 8u + salt) >> 8) / 16777216.0;
}
#endif
