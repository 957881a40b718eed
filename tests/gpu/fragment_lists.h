// Per-pixel lists that a method left behind, on the host.
#ifndef PLUME_TESTS_FRAGMENT_LISTS_H
#define PLUME_TESTS_FRAGMENT_LISTS_H

#include <algorithm>

#include "renderer/methods/method.h"
#include "shaders/methods/parts/fragment_list/fragment_list.h"

namespace plume {

struct FragmentLists {
  std::vector<uint32_t> heads;
  std::vector<shared::FragmentNode> nodes;
  uint32_t count;

  FragmentLists(gpu::Device& device, const Resources& resources)
      : heads(gpu::read<uint32_t>(device, resources.buffer("heads"))),
        nodes(gpu::read<shared::FragmentNode>(device, resources.buffer("nodes"))),
        count(gpu::read<shared::FragmentPool>(device, resources.buffer("pool"))[0].count) {}

  /// A pixel's, in the order of its links.
  std::vector<shared::FragmentNode> of(size_t pixel) const {
    std::vector<shared::FragmentNode> list;
    for (uint32_t n = heads[pixel]; n != shared::kListEnd; n = nodes[n].next) list.push_back(nodes[n]);
    return list;
  }
};

}  // namespace plume
#endif
