// Cells of pixels along whose rays a method keeps absorbance A(z) = -ln T(z), and where along its ray a depth lies:
//   place = ln(z / near) / ln(far / near), in [0, 1],
// where near and far are those of the cell's own fragments or the scene's.
// Limits: a cell larger than a pixel takes each card where its centre meets it.
#ifndef PLUME_ABSORBANCE_CELLS_GLSL
#define PLUME_ABSORBANCE_CELLS_GLSL
#include "surface/inside.glsl"

layout(constant_id = 0) const uint kDivisor = 1u;      // pixels a cell, each way
layout(constant_id = 1) const uint kCellRange = 1u;    // 0: of the scene
layout(constant_id = 2) const uint kChannels = 1u;     // 1: the mean of RGB; 3
layout(constant_id = 3) const uint kExcludeSelf = 1u;
layout(constant_id = 4) const float kNear = 0.0;       // m, of the scene's range; 0: the view's
layout(constant_id = 5) const float kFar = 0.0;

const float kLeastTransmittance = 1.1e-7;   // e^-16: an opaque fragment counts as much
const float kBehind = 2.0;   // the place of what lies behind everything in its cell

// Of a fragment that lets so much pass, in the channels that are kept.
vec3 absorbance_of(vec3 transmittance) {
  const vec3 passed = kChannels == 3u ? transmittance : vec3(dot(transmittance, vec3(1.0 / 3.0)));
  return -log(clamp(passed, vec3(kLeastTransmittance), vec3(1.0)));
}

vec2 scene_range() {
  const float near = kNear > 0.0 ? kNear : view.near_m;
  return vec2(near, max(kFar > 0.0 ? kFar : view.far_m, near));
}

uvec2 cells() { return (view.size + kDivisor - 1u) / kDivisor; }
uint cell_index(uvec2 cell) { return index_inside(cell, cells()); }

// A cell's range as it is kept: so that both come from atomicMax on zeros, the nearest is complemented. Bits of positive floats are
// ordered as they are.
uvec2 pack_range(float depth) { return uvec2(~floatBitsToUint(depth), floatBitsToUint(depth)); }
vec2 unpack_range(uvec2 range) { return uintBitsToFloat(uvec2(~range.x, range.y)); }

float place_in(uvec2 packed_range, float depth) {
  vec2 range = scene_range();
  if (kCellRange != 0u) {
    if (packed_range.y == 0u) return kBehind;   // nothing is there
    range = unpack_range(packed_range);
    if (depth > range.y * 1.00001) return kBehind;   // nearer than that it is the farthest fragment itself
  }
  return clamp(log(depth / range.x) / max(log(range.y / range.x), 1e-6), 0.0, 1.0);
}

#endif
