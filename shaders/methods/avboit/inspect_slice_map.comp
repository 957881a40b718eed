// A look at AVBOIT's depth warp as a chart over the picture: physical slices from left to right, the virtual slice of each as the height
// and the number of its bar.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/depth_warp.glsl"
#include "inspect/inspect.glsl"

// The virtual slice that holds a physical one: the last in front of which there are no more physical slices than that.
uint virtual_of(uint physical) {
  uint low = 0u, high = warp.virtual_slices;   // nodes[low] <= physical < nodes[high]
  while (high - low > 1u) {
    const uint middle = (low + high) / 2u;
    if (uint(nodes[middle]) <= physical) low = middle;
    else high = middle;
  }
  return low;
}

bool inspect(uvec2 pixel, out float value) {
  value = 0.0;
  if (warp.used == 0u) return false;
  const uint place = virtual_of(pixel.x * warp.used / look.size.x);
  value = float(place);
  const float height = (float(place) + 1.0) / float(warp.virtual_slices);
  return float(look.size.y - pixel.y) - 0.5 <= max(height * float(look.size.y), 1.0);
}
