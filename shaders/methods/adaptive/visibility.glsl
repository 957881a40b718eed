// Adaptive transparency's visibility of a pixel: what passes from a depth to the camera, as a step function of kNodes nodes, each
// of a depth and of the transmittance behind it. Inserting a fragment adds a node and dims all behind it. When there are too many,
// the node goes whose removal changes the integral of the function least,
//   error_i = (z_i - z_{i-1}) (T_{i-1} - T_i),
// and its step moves to the node in front of it: visibility is underestimated between the two, never overestimated. The first and
// the last node stay, so what the whole pixel lets through remains exact.
#ifndef PLUME_ADAPTIVE_VISIBILITY_GLSL
#define PLUME_ADAPTIVE_VISIBILITY_GLSL
#include "methods/parts/fragment_list/merge_sort.glsl"

layout(constant_id = 0) const uint kNodes = 8u;
layout(constant_id = 1) const uint kRgb = 1u;   // a transmittance for each channel; else their mean

const float kNowhere = 3.0e38;   // depth of a node that is not in use
float node_depth[kNodes + 1u];
uint node_card[kNodes + 1u];     // orders nodes of one depth
vec3 node_through[kNodes + 1u];

// Card by card: an order of insertion that has nothing to do with depth, nor with the order of draws. The last comes first, since a
// list that was appended to in the order of cards then needs no sorting.
bool before(Nodes list, uint a, uint b) { return list.nodes[a].id > list.nodes[b].id; }

bool in_front(uint node, float depth, uint card) {
  return node_depth[node] < depth || (node_depth[node] == depth && node_card[node] < card);
}

void remove_least_node() {
  float least = kNowhere;
  uint removed = 1u;
  for (uint i = 1u; i < kNodes; ++i) {
    const float error = (node_depth[i] - node_depth[i - 1u]) * dot(node_through[i - 1u] - node_through[i], vec3(1.0 / 3.0));
    if (error < least) {
      least = error;
      removed = i;
    }
  }
  for (uint i = 1u; i < kNodes; ++i)
    if (i >= removed) {
      node_through[i - 1u] = node_through[i];
      node_depth[i] = node_depth[i + 1u];
      node_card[i] = node_card[i + 1u];
    }
  node_through[kNodes - 1u] = node_through[kNodes];
  node_depth[kNodes] = kNowhere;
}

void insert_node(float depth, uint card, vec3 t) {
  for (uint i = kNodes + 1u; i-- > 0u;) {
    if (in_front(i, depth, card)) continue;
    if (i > 0u && !in_front(i - 1u, depth, card)) {
      node_depth[i] = node_depth[i - 1u];
      node_card[i] = node_card[i - 1u];
      node_through[i] = node_through[i - 1u] * t;
    } else {
      node_depth[i] = depth;
      node_card[i] = card;
      node_through[i] = i > 0u ? node_through[i - 1u] * t : t;
    }
  }
  if (node_depth[kNodes] < kNowhere) remove_least_node();
}

// Of a list of fragments, in the order of the list. What blocks nothing has no node.
void build_visibility(Nodes list, uint node) {
  for (uint i = 0u; i <= kNodes; ++i) {
    node_depth[i] = kNowhere;
    node_card[i] = 0u;
    node_through[i] = vec3(1.0);
  }
  for (; node != kListEnd; node = list.nodes[node].next) {
    vec3 t = list.nodes[node].transmittance;
    if (kRgb == 0u) t = vec3(dot(t, vec3(1.0 / 3.0)));
    if (t != vec3(1.0)) insert_node(list.nodes[node].depth, list.nodes[node].id, t);
  }
}

// In front of a card's fragment at a depth; its own node does not count.
vec3 visibility(float depth, uint card) {
  vec3 t = vec3(1.0);
  for (uint i = 0u; i < kNodes; ++i)
    if (in_front(i, depth, card)) t = node_through[i];
  return t;
}

vec3 total_visibility() { return node_through[kNodes - 1u]; }

#endif
