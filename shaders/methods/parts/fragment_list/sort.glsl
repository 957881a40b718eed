// Reading the lists front to back: sorts one by (depth, card).
#ifndef PLUME_FRAGMENT_LIST_SORT_GLSL
#define PLUME_FRAGMENT_LIST_SORT_GLSL
#include "methods/parts/fragment_list/merge_sort.glsl"

bool before(Nodes list, uint a, uint b) {
  const float depth_a = list.nodes[a].depth, depth_b = list.nodes[b].depth;
  return depth_a < depth_b || (depth_a == depth_b && list.nodes[a].id < list.nodes[b].id);
}

#endif
