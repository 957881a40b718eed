// AVBOIT, integrate: sums extinction along each ray. Where a slice s is occupied, layer s of the integral holds the value in front of
// it and behind it, so that one fetch, filtered across cells, serves the interpolation inside it:
//   tau(s) = sum_{k < s} tau_k   (what self-excluded sampling reads),   or   T(s) = exp(-tau(s))   (what biased samplings read).
// A slice counts kFullSlice at most, and from the first overflowing one on every slice does: what shares such a slice must keep
// weights that half floats hold, or it turns black. The first slice behind which less than the zero transmittance is left is recorded.
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_image_load_formatted : require
#include "methods/avboit/occupied.glsl"
#include "methods/avboit/extinction.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(constant_id = 6) const uint kRgb = 0u;              // RGB sources are there
layout(constant_id = 3) const uint kTransmittance = 0u;    // stored instead of optical depth
layout(constant_id = 4) const uint kEightBits = 0u;        // transmittance rounded as an 8-bit image would
layout(scalar, binding = 12) readonly buffer Overflow { uint overflow[]; };
layout(binding = 13) writeonly uniform image2DArray integral;
layout(scalar, binding = 15) readonly buffer OverflowRgb { uint overflow_rgb[]; };
layout(binding = 16) writeonly uniform image2DArray integral_rg;   // of all sources: (r before, r behind, g before, g behind)
layout(scalar, binding = 17) writeonly buffer ZeroSlice { uint zero_slice[]; };
layout(scalar, binding = 18) writeonly buffer RgbStart { uint rgb_start[]; };   // first slice with RGB extinction, a tile
layout(binding = 19) writeonly uniform image2DArray integral_b;
layout(scalar, binding = 9) readonly buffer WarpTable { DepthWarp warp; };

float stored(float tau) {
  if (kTransmittance == 0u) return tau;
  const float t = tau >= kSaturatedDepth ? 0.0 : exp(-tau);
  return kEightBits != 0u ? round(t * 255.0) / 255.0 : t;
}

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  const uint masks = (warp.used + 31u) / 32u;
  if (kRgb != 0u && gl_LocalInvocationIndex == 0u) {
    uint start = kNoSlice;
    for (uint m = masks; m-- > 0u;) {
      const uint mask = rgb_mask(tile_index(), m);
      if (mask != 0u) start = m * 32u + uint(findLSB(mask));
    }
    rgb_start[tile_index()] = start;
  }
  if (any(greaterThanEqual(cell, volume.cells))) return;

  const uint ray = cell.y * volume.cells.x + cell.x;
  const uint saturated = overflow[ray];
  uvec3 saturated_rgb = uvec3(kNoSlice);
  if (kRgbWords == 1u) saturated_rgb = uvec3(overflow_rgb[ray * 3u], overflow_rgb[ray * 3u + 1u], overflow_rgb[ray * 3u + 2u]);
  float tau = 0.0;
  vec3 tau_rgb = vec3(0.0), all_before = vec3(stored(0.0));
  uint zero = kNoSlice;
  for (uint m = 0u; m < masks; ++m) {
    const uint scalar = scalar_mask(tile_index(), m), rgb = kRgb != 0u ? rgb_mask(tile_index(), m) : 0u;
    for (uint mask = scalar | rgb; mask != 0u; mask &= mask - 1u) {
      const uint bit = mask & -mask, slice = m * 32u + uint(findLSB(mask));
      if (slice >= warp.used) break;
      const float before = stored(tau);
      const float most = min(tau + kFullSlice, kSaturatedDepth);
      if ((scalar & bit) != 0u) tau = min(tau + scalar_depth(ivec2(cell), ray, slice), most);
      if (slice >= saturated) tau = most;
      imageStore(integral, ivec3(cell, slice), vec4(before, stored(tau), 0.0, 0.0));
      float least = tau;
      if (kRgb != 0u) {
        const vec3 most_rgb = min(tau_rgb + kFullSlice, kSaturatedDepth);
        if ((rgb & bit) != 0u) tau_rgb = min(tau_rgb + rgb_depth(ivec2(cell), ray, slice), most_rgb);
        tau_rgb = mix(tau_rgb, most_rgb, greaterThanEqual(uvec3(slice), saturated_rgb));
        const vec3 all = tau + tau_rgb;
        const vec3 behind = vec3(stored(all.r), stored(all.g), stored(all.b));
        imageStore(integral_rg, ivec3(cell, slice), vec4(all_before.r, behind.r, all_before.g, behind.g));
        imageStore(integral_b, ivec3(cell, slice), vec4(all_before.b, behind.b, 0.0, 0.0));
        all_before = behind;
        least = min(all.r, min(all.g, all.b));
      }
      if (least >= volume.zero_depth) zero = min(zero, slice);
    }
  }
  zero_slice[ray] = zero;
}
