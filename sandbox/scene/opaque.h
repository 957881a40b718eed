// The opaque image of a scene: sky and solids, with depth.
#ifndef PLUME_SCENE_OPAQUE_H
#define PLUME_SCENE_OPAQUE_H

#include "renderer/frame.h"
#include "sandbox/effects/lighting.h"
#include "sandbox/scene/scene.h"

namespace plume {

class OpaqueScene {
 public:
  OpaqueScene(gpu::Device& device, const std::vector<Solid>& solids);
  void record_depth(gpu::Frame& frame, const Targets& targets, const gpu::Buffer& view) const;
  /// Shades what `depth`, the opaque depth or something nearer, leaves visible.
  void record_color(gpu::Frame& frame, const Targets& targets, const gpu::Image& depth,
                    const gpu::Buffer& view, const Lighting* lighting = nullptr) const;

  const gpu::Buffer& solids() const { return solids_; }

 private:
  gpu::Buffer solids_;
  uint32_t count_;
};

}  // namespace plume
#endif
