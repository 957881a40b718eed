// AVBOIT, adaptation: from the finest virtual resolution, neighbours are merged (a bit of the coarser is the OR of two) until the
// occupied slices and their guards fit the physical budget. Then a prefix sum over them is the depth warp. One work group.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "methods/avboit/depth_curve.glsl"

layout(local_size_x = 256) in;
layout(scalar, binding = 8) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 9) buffer WarpTable {
  DepthWarp warp;
  float slice_ends[kMostSlices];
  float nodes[];
};
layout(scalar, binding = 10) readonly buffer Coverage { uint coverage[]; };

const uint kWords = kMostVirtualSlices / 32u;
const uint kWordsPerThread = kWords / 256u;
shared uint bits[kWords], apart[kWords];   // apart slices are covered ones
shared uint sums[256];

uint word_of(uint w, uint words) { return w < words ? bits[w] : 0u; }   // also for w = -1

// Covered slices with their guards; guards are fewer than 32.
uint guarded(uint w, uint words) {
  const uint here = bits[w], before = word_of(w - 1u, words), behind = word_of(w + 1u, words);
  uint all = here;
  for (uint g = 1u; g <= volume.guard_before; ++g) all |= (here >> g) | (behind << (32u - g));
  for (uint g = 1u; g <= volume.guard_after; ++g) all |= (here << g) | (before >> (32u - g));
  return all;
}

uint width_of(uint w, uint words, uint apart_width) {
  return uint(bitCount(guarded(w, words))) + (apart_width - 1u) * uint(bitCount(apart[w]));
}

// Physical slices in front of this thread's words; the total is left in sums[255].
uint scan(uint mine) {
  const uint thread = gl_LocalInvocationIndex;
  barrier();
  sums[thread] = mine;
  barrier();
  for (uint step = 1u; step < 256u; step *= 2u) {
    const uint other = thread >= step ? sums[thread - step] : 0u;
    barrier();
    sums[thread] += other;
    barrier();
  }
  return sums[thread] - mine;
}

uint halves(uint word) {   // bit i = bit 2i | bit 2i + 1
  uint b = (word | word >> 1) & 0x55555555u;
  b = (b | b >> 1) & 0x33333333u;
  b = (b | b >> 2) & 0x0f0f0f0fu;
  b = (b | b >> 4) & 0x00ff00ffu;
  return (b | b >> 8) & 0xffffu;
}

void main() {
  const uint thread = gl_LocalInvocationIndex;
  const bool fixed_slices = volume.fixed_slices != 0u;
  uint slices = fixed_slices ? volume.slices : volume.virtual_slices;
  for (uint w = thread; w < kWords; w += 256u) {
    const bool inside = w < slices / 32u;
    bits[w] = !inside ? 0u : fixed_slices ? 0xffffffffu : coverage[w];
    apart[w] = !inside || fixed_slices ? 0u : coverage[kWords + w];
  }
  barrier();

  uint apart_width = kApartWidth, before = 0u;
  for (;;) {
    const uint words = slices / 32u;
    uint mine = 0u;
    for (uint k = 0u; k < kWordsPerThread; ++k) {
      const uint w = thread * kWordsPerThread + k;
      if (w < words) mine += width_of(w, words, apart_width);
    }
    before = scan(mine);
    if (sums[255] <= volume.slices) break;
    if (slices == kLeastVirtualSlices) {   // they fit without setting apart
      apart_width = 1u;
      continue;
    }
    uint merged[kWordsPerThread], merged_apart[kWordsPerThread];
    for (uint k = 0u; k < kWordsPerThread; ++k) {
      const uint w = thread * kWordsPerThread + k;
      merged[k] = w < words / 2u ? halves(bits[2u * w]) | halves(bits[2u * w + 1u]) << 16 : 0u;
      merged_apart[k] = w < words / 2u ? halves(apart[2u * w]) | halves(apart[2u * w + 1u]) << 16 : 0u;
    }
    barrier();
    for (uint k = 0u; k < kWordsPerThread; ++k) {
      bits[thread * kWordsPerThread + k] = merged[k];
      apart[thread * kWordsPerThread + k] = merged_apart[k];
    }
    slices /= 2u;
    barrier();
  }

  const uint words = slices / 32u;
  const float scale = float(slices) / volume.curve_octaves;
  for (uint k = 0u; k < kWordsPerThread; ++k) {
    const uint w = thread * kWordsPerThread + k;
    if (w >= words) break;
    const uint occupied = guarded(w, words);
    for (uint bit = 0u; bit < 32u; ++bit) {
      const uint slice = w * 32u + bit, mask = 1u << bit;
      nodes[slice] = float(before);
      const uint width = (occupied & mask) == 0u ? 0u : (apart[w] & mask) != 0u ? apart_width : 1u;
      for (uint part = 0u; part < width; ++part)
        slice_ends[before + part] = depth_of_slice(volume, scale, float(slice) + float(part + 1u) / float(width));
      before += width;
    }
    if (w == words - 1u) nodes[slices] = float(before);
  }
  if (thread == 0u)
    warp = DepthWarp(slices, sums[255], scale, apart_width == 1u ? 1u : 0u);
}
