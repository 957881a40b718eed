// AVBOIT, coverage: which virtual slices, at the finest resolution, hold any part of any card that is on the screen. One bit a
// slice, no guards: they are added when the resolution is known. Behind it as many bits of slices to be set apart.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "surface/bounds.glsl"
#include "surface/seen_cards.glsl"
#include "methods/avboit/depth_curve.glsl"

layout(local_size_x = kItemGroup) in;
layout(scalar, binding = 0) uniform View { ViewData view; };
layout(scalar, binding = 1) readonly buffer Cards { Card cards[]; };
layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 9) buffer Coverage { uint coverage[]; };

const uint kWords = kMostVirtualSlices / 32u;
shared uint bits[kWords], apart[kWords];

void main() {
  const uint thread = gl_LocalInvocationIndex, words = volume.virtual_slices / 32u;
  for (uint w = thread; w < words; w += 256u) bits[w] = apart[w] = 0u;
  barrier();
  const uint i = gl_GlobalInvocationID.x;
  if (i < work.count) {
    const Card card = cards[order[i]];
    const Bounds b = bounds_of(card, view);
    if (b.seen) {
      const float scale = float(volume.virtual_slices) / volume.curve_octaves;
      const uint first = uint(virtual_slice(volume, volume.virtual_slices, scale, b.nearest));
      const uint last = uint(virtual_slice(volume, volume.virtual_slices, scale, b.farthest));
      for (uint w = first / 32u; w <= last / 32u; ++w) {
        const uint from = w == first / 32u ? first & 31u : 0u, to = w == last / 32u ? last & 31u : 31u;
        const uint mask = (0xffffffffu >> (31u - to)) & (0xffffffffu << from);
        atomicOr(bits[w], mask);
        if ((card.layers & kCardSetApart) != 0u) atomicOr(apart[w], mask);
      }
    }
  }
  barrier();
  for (uint w = thread; w < words; w += 256u) {
    if (bits[w] != 0u) atomicOr(coverage[w], bits[w]);
    if (apart[w] != 0u) atomicOr(coverage[kWords + w], apart[w]);
  }
}
