// AVBOIT, resolve:  image_c = E_c + S_c (1 - prod t_c - N_c + e) / (M_c + e) + background prod t_c,
// with sums of C a T and of a T: E and N over what is known of the weights (see accumulate.glsl), S and M over the rest. The rest is
// scaled to cover what is left, which is the same share in each channel: were glass in front of smoke in the fraction, it would hide the
// smoke's error in the channels that it blocks and not in those that it passes, and the smoke would change its colour. What is in doubt
// may also be too little to bear all of the error: it grows by kMostGrowth at most, and then all is scaled alike.
// The small e (kEpsilon) makes the fraction 1 where nothing covers, so that emission without coverage passes as it is. It vanishes as
// coverage grows, since all weights may be small where much is in one slice, and grows with the rounding of N.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/colour.h"
#include "methods/avboit/depth_warp.glsl"
#include "methods/avboit/exact_layers.h"
#include "methods/avboit/overlap.h"
#include "surface/low_resolution.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 0) const uint kNormalise = 1u;
layout(constant_id = 1) const uint kColour = kFullRgb;
layout(constant_id = 2) const uint kHalf = 0u;        // soft particles were drawn at half resolution
layout(constant_id = 3) const uint kHasAlpha = 1u;    // of `light`: 11:11:10 has none
layout(binding = 10) uniform sampler2D light;
layout(binding = 11) uniform sampler2D norm;
layout(binding = 12) uniform sampler2D through;
layout(binding = 13) uniform sampler2D norm_rgb;
layout(binding = 14) uniform sampler2D known_light;
layout(binding = 26) uniform sampler2D known_norm;
layout(binding = 27) uniform sampler2D known_light_half;
layout(binding = 28) uniform sampler2D known_norm_half;
layout(binding = 15) uniform sampler2D light_half;
layout(binding = 16) uniform sampler2D norm_half;
layout(binding = 17) uniform sampler2D through_half;
layout(binding = 18) uniform sampler2D norm_rgb_half;
layout(binding = 19) uniform sampler2D half_opaque;
layout(binding = 20) uniform sampler2D opaque_depth;
layout(binding = 21) uniform sampler2D opaque_color;
layout(binding = 22, rgba16f) writeonly uniform image2D result;
layout(scalar, binding = 23) readonly buffer Layers { uvec2 layers[]; };
layout(scalar, binding = 24) readonly buffer Overlaps { Overlap overlaps[]; };
layout(scalar, binding = 25) buffer Flagged { uint flagged[]; };   // pixels where coloured events share a slice
layout(constant_id = 4) const uint kSkewGuard = 1u;
layout(push_constant) uniform Push { uvec2 size; };

const float kEpsilon = 1.0 / 1024.0;
const float kMostGrowth = 8.0;

struct Sums {
  vec4 light;     // rgb: sum (C a + E) T, a: prod(1 - a)
  vec4 through;   // rgb: prod t, a: prod(mean t)
  vec3 norm;      // sum a T
  vec3 known_light, known_norm;
};

Sums full_sums(ivec2 pixel) {
  const vec4 known = texelFetch(known_light, pixel, 0);
  Sums s = Sums(texelFetch(light, pixel, 0), texelFetch(through, pixel, 0), vec3(texelFetch(norm, pixel, 0).r), known.rgb, known.aaa);
  if (kColour == kFullRgb) s.norm += texelFetch(norm_rgb, pixel, 0).rgb, s.known_norm += texelFetch(known_norm, pixel, 0).rgb;
  if (kHasAlpha == 0u) s.light.a = 1.0;
  return s;
}

Sums half_sums(ivec2 pixel) {
  Sums s = Sums(vec4(0.0), vec4(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  const float here = texelFetch(opaque_depth, pixel, 0).r;
  float total = 0.0;
  for (int i = 0; i < 4; ++i) {
    const LowTap tap = low_tap(half_opaque, pixel, 2u, here, i);
    s.light += tap.weight * texelFetch(light_half, tap.at, 0);
    s.through += tap.weight * texelFetch(through_half, tap.at, 0);
    s.norm += tap.weight * texelFetch(norm_half, tap.at, 0).r;
    const vec4 known = texelFetch(known_light_half, tap.at, 0);
    s.known_light += tap.weight * known.rgb, s.known_norm += tap.weight * known.a;
    if (kColour == kFullRgb) {
      s.norm += tap.weight * texelFetch(norm_rgb_half, tap.at, 0).rgb;
      s.known_norm += tap.weight * texelFetch(known_norm_half, tap.at, 0).rgb;
    }
    total += tap.weight;
  }
  s.light /= total, s.through /= total, s.norm /= total, s.known_light /= total, s.known_norm /= total;
  if (kHasAlpha == 0u) s.light.a = 1.0;
  return s;
}

bool shares_slice(ivec2 pixel) {
  const uvec2 cell = uvec2(pixel) / volume.divisor;
  const uint ray = cell.y * volume.cells.x + cell.x, plane = size.x * size.y, first = uint(pixel.y) * size.x + uint(pixel.x);
  bool found = false;
  for (uint w = 0u; w < kMaskWords; ++w) found = found || (overlaps[ray].coloured[w] & overlaps[ray].shared_slices[w]) != 0u;
  float before = -2.0;
  for (uint k = 0u; k < volume.exact_layers; ++k) {
    const uvec2 layer = layers[k * plane + first];
    if (layer.y == kNoLayer) break;
    const float here = slice_at(layer_depth(layer.y));
    found = found || here - before < 1.0;
    before = here;
  }
  return found;
}

void main() {
  const ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(uvec2(pixel), size))) return;
  Sums s = full_sums(pixel);
  if (kHalf != 0u) {   // sums of the same kind: nothing is composited, so both resolutions mix in depth
    const Sums h = half_sums(pixel);
    s = Sums(vec4(s.light.rgb + h.light.rgb, s.light.a * h.light.a), s.through * h.through, s.norm + h.norm, s.known_light + h.known_light, s.known_norm + h.known_norm);
  }
  const vec3 passed = s.light.a * s.through.rgb;
  const vec3 covers = kColour == kFullRgb ? 1.0 - passed : vec3(1.0 - s.light.a * s.through.a);
  const vec3 left = max(1.0 - covers, 0.0), e = kEpsilon * (left * left + s.known_norm) + 1e-7;
  const vec3 growth = kNormalise == 0u ? vec3(1.0) : min((max(covers - s.known_norm, 0.0) + e) / (s.norm + e), kMostGrowth);
  vec3 seen = s.known_light + s.light.rgb * growth;
  const vec3 bare = kEpsilon * left * left + 1e-7;
  if (kNormalise != 0u) seen *= (covers + bare) / (s.known_norm + s.norm * growth + bare);
  if (kColour == kSkew || kColour == kFirstEvent) {
    const bool mixed = shares_slice(pixel);
    if (mixed) atomicAdd(flagged[0], 1u);
    if (!mixed || kSkewGuard == 0u) seen *= s.through.rgb / max(luma(s.through.rgb), 1e-30);
  }
  imageStore(result, pixel, vec4(seen + texelFetch(opaque_color, pixel, 0).rgb * passed, 1.0));
}
