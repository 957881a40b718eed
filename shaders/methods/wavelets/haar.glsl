// Absorbance over depth in the Haar basis. Aizenshtein, Smal and McGuire, "Wavelet Transparency", 2022.
//   A(x) = sum_i a_i [x > x_i],   x in [0, 1) along a cell's ray,
// is kept as its scale term s = sum a_i (1 - x_i) and, for each node of a binary tree of kRank + 1 levels,
//   d = -sum a_i min(u_i, 1 - u_i),   u_i: where in the node's interval x_i lies, 0..1,
// which is half the difference of the means of A over the interval's halves (the orthonormal basis scales d by 2^(-level/2) and the
// wavelet by its inverse: left out). A fragment lies in one node a level. The mean of A over a leaf, one of 2^(kRank + 1), is
// s +- d on the way to it; between neighbouring leaves' means A is interpolated.
//
// Places are scaled so that the last one is the last leaf's beginning: what is there is in the last leaf's mean, and not lost.
#ifndef PLUME_WAVELETS_HAAR_GLSL
#define PLUME_WAVELETS_HAAR_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#extension GL_EXT_shader_atomic_float : require
#include "methods/parts/absorbance/cells.glsl"

layout(constant_id = 6) const uint kRank = 3u;
layout(constant_id = 7) const uint kUnfold = 1u;   // the transform is inverted before it is read
layout(constant_id = 8) const uint kIntoRgb = 0u;  // of a splat: into the sums of each channel instead of those for all
layout(scalar, binding = 9) readonly buffer Address { uvec2 address; };   // of coefficients: they may be more than a binding holds
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Coefficients { float c[]; };   // [cell][coefficient][sum]

const uint kLeaves = 2u << kRank;   // and coefficients: the scale term, then nodes; the children of n are 2n and 2n + 1
// Sums a coefficient: of what dims all channels alike, then, where there are channels, of what does not.
const uint kSums = kChannels == 3u ? 4u : 1u;

uint coefficient(uvec2 cell, uint n) { return (cell_index(cell) * kLeaves + n) * kSums; }

void add_to(uint at, vec3 value) {
  if (kIntoRgb != 0u)
    for (uint c = 0u; c < 3u; ++c) atomicAdd(Coefficients(address).c[at + 1u + c], value[c]);
  else
    atomicAdd(Coefficients(address).c[at], value.r);
}
vec3 rgb_of(uint at) {
  Coefficients from = Coefficients(address);
  return vec3(from.c[at + 1u], from.c[at + 2u], from.c[at + 3u]);
}
vec3 value_of(uint at) {
  const float all = Coefficients(address).c[at];
  return kChannels == 3u ? all + rgb_of(at) : vec3(all);
}
// Of the mean over a leaf, where unfold.comp has been.
vec3 leaf_of(uint at) { return kChannels == 3u ? rgb_of(at) : vec3(Coefficients(address).c[at]); }

float in_leaves(float place) { return min(place, 1.0) * float(kLeaves - 1u); }

void add_step(uvec2 cell, float place, vec3 absorbance) {
  float u = in_leaves(place) / float(kLeaves);
  add_to(coefficient(cell, 0u), absorbance * (1.0 - u));
  uint node = 1u;
  for (uint level = 0u; level <= kRank; ++level) {
    add_to(coefficient(cell, node), -absorbance * min(u, 1.0 - u));
    const float half_of = floor(2.0 * u);   // u < 1
    node = 2u * node + uint(half_of);
    u = 2.0 * u - half_of;
  }
}

// Means over leaf - 1, 0 before the first, and leaf.
void means_of(uvec2 cell, uint leaf, out vec3 before, out vec3 here) {
  if (kUnfold != 0u) {
    here = leaf_of(coefficient(cell, leaf));
    before = leaf == 0u ? vec3(0.0) : leaf_of(coefficient(cell, leaf - 1u));
    return;
  }
  const vec3 scale = value_of(coefficient(cell, 0u));
  before = here = scale;
  uint node = kLeaves + leaf, other = kLeaves + max(leaf, 1u) - 1u;
  for (uint level = 0u; level <= kRank; ++level) {
    here += ((node & 1u) == 0u ? 1.0 : -1.0) * value_of(coefficient(cell, node >> 1u));
    before += ((other & 1u) == 0u ? 1.0 : -1.0) * value_of(coefficient(cell, other >> 1u));
    node >>= 1u;
    other >>= 1u;
  }
  if (leaf == 0u) before = vec3(0.0);
}

// What a step of absorbance 1 adds to the mean over a leaf.
float share_in(int leaf, float step_at) { return clamp(float(leaf + 1) - step_at, 0.0, 1.0); }

vec3 absorbance_at(uvec2 cell, float place, vec3 own) {
  const float at = place == kBehind ? float(kLeaves) : in_leaves(place), own_at = in_leaves(place);
  const uint leaf = min(uint(at), kLeaves - 1u);
  const float part = at - float(leaf);
  vec3 before, here;
  means_of(cell, leaf, before, here);
  return mix(before, here, part) - own * mix(share_in(int(leaf) - 1, own_at), share_in(int(leaf), own_at), part);
}

#endif
