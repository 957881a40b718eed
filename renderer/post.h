// What is done to a method's picture before it is displayed: haze bends it, and a lens blurs it.
#ifndef PLUME_RENDERER_POST_H
#define PLUME_RENDERER_POST_H

#include "renderer/frame.h"

namespace plume {

/// The passes that a picture of these targets gets: none where `written` and the targets' lens are empty.
class PostChain {
 public:
  PostChain(const Targets& targets, const Outputs& written);

  /// What the method draws into, so that the last pass ends in targets.result.
  const gpu::Image& method_target() const;
  /// distort, depth_of_field.
  void record(gpu::Frame& frame, const gpu::Buffer& view) const;

 private:
  const Targets& targets_;
  Outputs written_;
};

/// Tiles of which the largest circle of confusion is known; see shaders/post/lens.h.
glm::uvec2 circle_tile_count(glm::uvec2 size);

}  // namespace plume
#endif
