// Which cards show anything: those of particles that are not born, dead, or behind the camera are left out,
// on the device, so that methods sort, classify and draw only what there is. A stable compaction: one round
// of a radix sort by source.
#ifndef PLUME_RENDERER_SEEN_CARDS_H
#define PLUME_RENDERER_SEEN_CARDS_H

#include "renderer/transparents.h"

namespace plume {

class SeenCards {
 public:
  explicit SeenCards(gpu::Device& device);
  /// Makes room for so many cards, and has `transparents` draw what will be seen of them.
  void fit(Transparents& transparents);
  /// The pass "seen cards". `submission`: uint[count], a permutation of all cards that keeps those of each
  /// source together.
  void record(gpu::Frame& frame, const Transparents& transparents, const gpu::Buffer& submission) const;

 private:
  gpu::Device& device_;
  uint32_t capacity_ = 0;
  gpu::Buffer pairs_, sorted_pairs_, counts_, order_;
  gpu::Buffer all_, seen_;  ///< shared::Workload
  gpu::Buffer draws_;       ///< shared::DrawCommand[1 + kSources]
};

}  // namespace plume
#endif
