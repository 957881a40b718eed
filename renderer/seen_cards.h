// Which cards show anything: those of particles that are not born, dead, or behind the camera are left out,
// on the device, so that methods sort, classify and draw only what there is. A stable compaction: one round
// of a radix sort by source. Cards with a number that nothing can be drawn with are left out and counted:
// no light, no sort and no method meets one.
#ifndef PLUME_RENDERER_SEEN_CARDS_H
#define PLUME_RENDERER_SEEN_CARDS_H

#include "renderer/transparents.h"
#include "shaders/shared/bad_number.h"

namespace plume {

class SeenCards {
 public:
  explicit SeenCards(gpu::Device& device);
  /// Makes room for so many cards, and has `transparents` draw what will be seen of them.
  void fit(Transparents& transparents);
  /// The pass "seen cards". `submission`: uint[count], a permutation of all cards that keeps those of each
  /// source together.
  void record(gpu::Frame& frame, const Transparents& transparents, const gpu::Buffer& submission) const;

  /// shared::BadCards, which later passes may add to what they leave out.
  const gpu::Buffer& bad_buffer() const { return bad_; }
  /// What the last frame that is finished left out.
  shared::BadCards bad() const { return bad_.mapped<shared::BadCards>()[0]; }

 private:
  gpu::Device& device_;
  uint32_t capacity_ = 0;
  gpu::Buffer pairs_, sorted_pairs_, counts_, order_;
  gpu::Buffer all_, seen_;  ///< shared::Workload
  gpu::Buffer draws_;       ///< shared::DrawCommand[1 + kSources]
  gpu::Buffer bad_;         ///< host-visible, so that to read it waits for nothing
};

}  // namespace plume
#endif
