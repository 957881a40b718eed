// AVBOIT, integrate: sums extinction along each ray into transmittance, one texel a slice.
//   integral[s + 1] = exp(-sum_{k <= s} tau_k),  integral[0] = 1, and 0 from the first overflowing slice on.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/volume.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 9) readonly buffer Extinction { uint extinction[]; };
layout(scalar, binding = 10) readonly buffer Overflow { uint overflow[]; };
layout(binding = 11, r8) writeonly uniform image3D integral;

void main() {
  const uvec2 cell = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(cell, volume.cells))) return;
  const uint ray = cell.y * volume.cells.x + cell.x;
  const uint words = volume.slices / 4u;
  const uint saturated = overflow[ray];
  float tau = 0.0;
  imageStore(integral, ivec3(cell, 0), vec4(1.0));
  for (uint word = 0u; word < words; ++word) {
    const uint fields = extinction[ray * words + word];
    for (uint lane = 0u; lane < 4u; ++lane) {
      const uint slice = word * 4u + lane;
      tau += float((fields >> (8u * lane)) & 255u) * (kLog255 / 255.0);
      const float transmittance = slice >= saturated ? 0.0 : exp(-tau);
      imageStore(integral, ivec3(cell, slice + 1u), vec4(transmittance));
    }
  }
}
