// AVBOIT, integrate: sums extinction along each ray. Where a slice s is occupied, word s of the integral holds the value in front of
// it and behind it as two half floats, so one load serves the interpolation inside it:
//   tau(s) = sum_{k < s} tau_k   (what self-excluded sampling reads),   or   T(s) = exp(-tau(s))   (what biased samplings read).
// From the first overflowing slice on T = 0. The first slice behind which less than the zero transmittance is left is recorded.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/occupied.glsl"
#include "methods/avboit/fields.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 1) const uint kLaneBits = 16u;
layout(constant_id = 2) const uint kRgbWords = 3u;         // of extinction a slice: 0 none, 1 packed, 3 apart
layout(constant_id = 3) const uint kTransmittance = 0u;    // stored instead of optical depth
layout(constant_id = 4) const uint kEightBits = 0u;        // transmittance rounded as an 8-bit image would
layout(scalar, binding = 11) readonly buffer Extinction { uint extinction[]; };
layout(scalar, binding = 12) readonly buffer Overflow { uint overflow[]; };
layout(scalar, binding = 13) writeonly buffer Integral { uint integral[]; };
layout(scalar, binding = 14) readonly buffer ExtinctionRgb { uint extinction_rgb[]; };
layout(scalar, binding = 15) readonly buffer OverflowRgb { uint overflow_rgb[]; };
layout(scalar, binding = 16) writeonly buffer IntegralRgb { uint integral_rgb[]; };
layout(scalar, binding = 17) writeonly buffer ZeroSlice { uint zero_slice[]; };
layout(scalar, binding = 18) writeonly buffer RgbStart { uint rgb_start[]; };   // first slice with RGB extinction, a tile
layout(scalar, binding = 19) readonly buffer WarpTable { DepthWarp warp; };

float stored(float tau) {
  if (kTransmittance == 0u) return tau;
  const float t = tau >= kSaturatedDepth ? 0.0 : exp(-tau);
  return kEightBits != 0u ? round(t * 255.0) / 255.0 : t;
}

float scalar_depth(uint ray, uint slice) {
  const uint lanes = 32u / kLaneBits;
  const uint word = extinction[ray * (volume.slices / lanes) + slice / lanes];
  return float((word >> (kLaneBits * (slice % lanes))) & full_field(kLaneBits)) / steps_per_depth(kLaneBits);
}

vec3 rgb_depth(uint ray, uint slice) {
  if (kRgbWords == 1u) {
    const uint word = extinction_rgb[ray * volume.slices + slice];
    return vec3(uvec3(word, word >> 10, word >> 20) & 1023u) / steps_per_depth(8u);
  }
  const uint first = (ray * volume.slices + slice) * 3u;
  return vec3(extinction_rgb[first], extinction_rgb[first + 1u], extinction_rgb[first + 2u]) / steps_per_depth(32u);
}

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  const uint masks = (warp.used + 31u) / 32u;
  uint start = kNoSlice;   // over the neighbours too: filtering at a tile's edge reads their cells
  if (kRgbWords != 0u) {
    const ivec2 tile = ivec2(gl_WorkGroupID.xy), last_tile = ivec2(volume.tiles) - 1;
    for (int n = 0; n < 9; ++n) {
      const ivec2 at = clamp(tile + ivec2(n % 3, n / 3) - 1, ivec2(0), last_tile);
      for (uint m = masks; m-- > 0u;) {
        const uint mask = rgb_mask(uint(at.y) * volume.tiles.x + uint(at.x), m);
        if (mask != 0u) start = min(start, m * 32u + uint(findLSB(mask)));
      }
    }
    if (gl_LocalInvocationIndex == 0u) rgb_start[tile_index()] = start;
  }
  if (any(greaterThanEqual(cell, volume.cells))) return;

  const uint plane = volume.cells.x * volume.cells.y, ray = cell.y * volume.cells.x + cell.x;
  const uint saturated = overflow[ray];
  uvec3 saturated_rgb = uvec3(kNoSlice);
  if (kRgbWords == 1u) saturated_rgb = uvec3(overflow_rgb[ray * 3u], overflow_rgb[ray * 3u + 1u], overflow_rgb[ray * 3u + 2u]);
  float tau = 0.0;
  vec3 tau_rgb = vec3(0.0);
  uint zero = kNoSlice;
  for (uint m = 0u; m < masks; ++m) {
    const uint scalar = scalar_mask(tile_index(), m), rgb = kRgbWords != 0u ? rgb_mask(tile_index(), m) : 0u;
    for (uint mask = scalar | rgb; mask != 0u; mask &= mask - 1u) {
      const uint bit = mask & -mask, slice = m * 32u + uint(findLSB(mask));
      if (slice >= warp.used) break;
      const float before = stored(tau);
      if ((scalar & bit) != 0u) tau += scalar_depth(ray, slice);
      if (slice >= saturated) tau = kSaturatedDepth;
      integral[slice * plane + ray] = packHalf2x16(vec2(before, stored(tau)));
      float least = tau;
      if (start != kNoSlice) {
        const vec3 rgb_before = vec3(stored(tau_rgb.r), stored(tau_rgb.g), stored(tau_rgb.b));
        if ((rgb & bit) != 0u) tau_rgb += rgb_depth(ray, slice);
        tau_rgb = mix(tau_rgb, vec3(kSaturatedDepth), greaterThanEqual(uvec3(slice), saturated_rgb));
        for (uint c = 0u; c < 3u; ++c)
          integral_rgb[(slice * plane + ray) * 3u + c] = packHalf2x16(vec2(rgb_before[c], stored(tau_rgb[c])));
        least += min(tau_rgb.r, min(tau_rgb.g, tau_rgb.b));
      }
      if (least >= volume.zero_depth) zero = min(zero, slice);
    }
  }
  zero_slice[ray] = zero;
}
