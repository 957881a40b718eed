// The order of a frame's passes, written once: opaque things, the method's own passes, the displayed image.
#ifndef PLUME_RENDERER_FRAME_H
#define PLUME_RENDERER_FRAME_H

#include "renderer/methods/method.h"

namespace plume {

/// The images every method shares for one picture size.
struct Targets {
  Targets(gpu::Device& device, glm::uvec2 size);

  glm::uvec2 size;
  gpu::Image opaque_color;  ///< kHdrFormat
  gpu::Image opaque_depth;  ///< D32, reversed: near_m / view depth, 0 = sky
  gpu::Image result;        ///< kHdrFormat, linear
  gpu::Image display;       ///< R8G8B8A8, tone-mapped and sRGB-encoded
};

/// A method with its resources: what one view of a comparison owns.
struct MethodInstance {
  std::unique_ptr<Method> method;
  std::string owner;  ///< account of its memory: unique where the same method runs twice with other settings
  Resources resources;
};

/// Records what transparent things are drawn over and into.
struct Prelude {
  std::function<void(gpu::Frame&, const Targets&)> geometry;  ///< cards, and the depth of opaque things
  /// The opaque image, of what `depth` (the opaque depth or something nearer) leaves visible.
  std::function<void(gpu::Frame&, const Targets&, const gpu::Image& depth)> opaque;
};

struct FrameReport {
  std::vector<gpu::PassTime> passes;  ///< of the last, complete drawing
  uint32_t redraws = 0;               ///< drawings thrown away because the method had to grow
};

/// Draws one frame and waits for it.
FrameReport render_frame(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                         const Prelude& prelude, const Transparents& transparents, MethodInstance& instance);

}  // namespace plume
#endif
