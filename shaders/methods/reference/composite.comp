// Exact transparency, second half: each pixel's list is sorted by (depth, card) and composited front to back in 32 bits,
//   image = sum_i L_i prod_{j<i} t_j  +  background prod_i t_i.
// Bottom-up merge sort on the links (no arrays, so no limit): O(n log n).
#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/reference.h"

layout(local_size_x = 8, local_size_y = 8) in;
layout(scalar, binding = 8) readonly buffer Pool { FragmentPool pool; };
layout(scalar, binding = 9) buffer Heads { uint heads[]; };
layout(binding = 10) uniform sampler2D opaque_color;
layout(binding = 11, rgba16f) writeonly uniform image2D result;
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Nodes { FragmentNode nodes[]; };
layout(push_constant) uniform Push { uvec2 size; };

bool before(Nodes list, uint a, uint b) {
  const float depth_a = list.nodes[a].depth, depth_b = list.nodes[b].depth;
  return depth_a < depth_b || (depth_a == depth_b && list.nodes[a].id < list.nodes[b].id);
}

uint merge(Nodes list, uint a, uint b) {
  if (a == kListEnd) return b;
  if (b == kListEnd) return a;
  uint head = kListEnd, tail = kListEnd;
  while (a != kListEnd && b != kListEnd) {
    uint taken;
    if (before(list, a, b)) {
      taken = a;
      a = list.nodes[a].next;
    } else {
      taken = b;
      b = list.nodes[b].next;
    }
    if (head == kListEnd) head = taken;
    else list.nodes[tail].next = taken;
    tail = taken;
  }
  list.nodes[tail].next = a != kListEnd ? a : b;
  return head;
}

const uint kBins = 28u;   // runs of 2^bin fragments; more than any pool holds

uint sort(Nodes list, uint head) {
  uint bins[kBins];
  uint used = 0u;
  while (head != kListEnd) {
    uint run = head;
    head = list.nodes[run].next;
    list.nodes[run].next = kListEnd;
    uint bin = 0u;
    for (; bin < used && bins[bin] != kListEnd; ++bin) {
      run = merge(list, bins[bin], run);
      bins[bin] = kListEnd;
    }
    if (bin == used) ++used;
    bins[bin] = run;
  }
  uint sorted = kListEnd;
  for (uint bin = 0u; bin < used; ++bin) sorted = merge(list, bins[bin], sorted);
  return sorted;
}

void main() {
  const uvec2 pixel = gl_GlobalInvocationID.xy;
  if (any(greaterThanEqual(pixel, size))) return;
  Nodes list = Nodes(pool.address);
  vec3 light = vec3(0.0), through = vec3(1.0);
  const uint ray = pixel.y * size.x + pixel.x;
  // On overflow the lists are incomplete and the frame is drawn again: sorting them would be wasted.
  uint node = pool.count > pool.capacity ? kListEnd : sort(list, heads[ray]);
  heads[ray] = node;   // left front to back, for whoever wants the fragments of a pixel
  for (; node != kListEnd; node = list.nodes[node].next) {
    light += list.nodes[node].light * through;
    through *= list.nodes[node].transmittance;
  }
  const vec3 background = texelFetch(opaque_color, ivec2(pixel), 0).rgb;
  imageStore(result, ivec2(pixel), vec4(light + background * through, 1.0));
}
