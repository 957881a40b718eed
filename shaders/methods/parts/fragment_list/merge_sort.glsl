// Merge sort of a pixel's list, on the links, bottom up: there is no limit to its length, and it takes O(n log n), or O(n) where
// the list is in order. Whoever includes this says by before() what the order is.
#ifndef PLUME_FRAGMENT_LIST_MERGE_SORT_GLSL
#define PLUME_FRAGMENT_LIST_MERGE_SORT_GLSL
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_buffer_reference_uvec2 : require
#include "methods/parts/fragment_list/fragment_list.h"

layout(scalar, binding = 8) readonly buffer Pool { FragmentPool pool; };
layout(scalar, binding = 9) buffer Heads { uint heads[]; };
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Nodes { FragmentNode nodes[]; };

// Whether fragment a belongs in front of b in the sorted list.
bool before(Nodes list, uint a, uint b);

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

const uint kBins = 28u;   // of 2^bin runs; more than any pool holds

uint sort(Nodes list, uint head) {
  uint bins[kBins];
  uint used = 0u;
  while (head != kListEnd) {
    uint run = head, last = head;   // as far as it is in order already
    for (head = list.nodes[last].next; head != kListEnd && before(list, last, head); head = list.nodes[last].next) last = head;
    list.nodes[last].next = kListEnd;
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

#endif
