// The order of a frame's passes, written once: opaque things, the method's own passes, what is done to its
// picture, the displayed image.
#ifndef PLUME_RENDERER_FRAME_H
#define PLUME_RENDERER_FRAME_H

#include "renderer/glance.h"
#include "renderer/probe.h"

namespace plume {

/// A thin lens.
struct Lens {
  float focus_m = 5.0f;       ///< view depth that is sharp
  float aperture_mm = 25.0f;  ///< diameter of the opening: the wider, the more everything else blurs
  bool operator==(const Lens&) const = default;
};

/// What is done to a picture after the method. Nothing of it costs anything where it is not asked for.
struct Post {
  bool distortion = false;   ///< haze may come: it bends what is seen through it
  bool surface = false;      ///< depth and motion of what is transparent are asked for
  std::optional<Lens> lens;  ///< depth of field; wants `surface` itself
  Outputs wanted() const { return {.distortion = distortion, .surface = surface || lens.has_value()}; }
  bool operator==(const Post&) const = default;
};

/// The images every method shares for one picture size.
struct Targets {
  Targets(gpu::Device& device, glm::uvec2 size, const Post& post = {});

  glm::uvec2 size;
  Post post;
  gpu::Image opaque_color;  ///< kHdrFormat
  gpu::Image opaque_depth;  ///< D32, reversed: near_m / view depth, 0 = sky
  gpu::Image result;        ///< kHdrFormat, linear
  gpu::Image display;       ///< R8G8B8A8, tone-mapped and sRGB-encoded

  // Empty unless `post` asks for them.
  gpu::Image distortion, surface;    ///< see Outputs
  gpu::Image composed;               ///< kHdrFormat: between the method and the passes after it
  gpu::Image circles, circle_tiles;  ///< of confusion: see shaders/post/circles.comp
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
  double transparency_ms = 0.0;       ///< of those, the method's own: not what is the same for all methods
  uint32_t redraws = 0;               ///< drawings thrown away because the method had to grow
  std::vector<std::string> left_out;  ///< outputs that the picture wants and the method does not write
};

/// Draws one frame and waits for it; with a probe, lets the method answer it; with a glance, takes that too.
FrameReport render_frame(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                         const Prelude& prelude, const Transparents& transparents, MethodInstance& instance,
                         const Probe* probe = nullptr, const Glance* glance = nullptr);

}  // namespace plume
#endif
