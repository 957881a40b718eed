// The depth warp: from depth to physical slice, skipping what is empty. nodes[i] is the number of physical slices in front of
// virtual slice i, so the table is filtered linearly: inside an occupied slice it rises, in an empty range it stays, which is
// the talk's snap to the end of the previous range without begin and end marks.
#ifndef PLUME_AVBOIT_DEPTH_WARP_GLSL
#define PLUME_AVBOIT_DEPTH_WARP_GLSL
#include "methods/avboit/depth_curve.glsl"

layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 9) readonly buffer WarpTable {
  DepthWarp warp;
  float slice_ends[kMostSlices];   // depth, m, where each physical slice ends
  float nodes[];
};

float slice_at(float depth) {
  const float v = virtual_slice(volume, warp.virtual_slices, warp.scale, depth);
  const uint i = uint(v);
  return mix(nodes[i], nodes[i + 1u], v - float(i));
}
#endif
