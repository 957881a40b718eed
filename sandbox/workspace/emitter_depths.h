// How far from the camera an instance's particles are, and how far they are drawn: a camera offset moves them
// along the line of sight (shaders/effects/look.glsl), to land in other slices of depth than they are in.
#ifndef PLUME_WORKSPACE_EMITTER_DEPTHS_H
#define PLUME_WORKSPACE_EMITTER_DEPTHS_H

#include <string>
#include <vector>

#include "sandbox/scene/stage.h"

namespace plume {

struct EmitterDepths {
  std::string name;
  float offset_m = 0.0f;        ///< towards the camera, that of its layer included
  std::vector<float> depths_m;  ///< view depth of each that lives, without the offset; ascending
  bool has_states = true;       ///< false: analytic, where the host does not know

  /// The depth at which a particle at `depth_m` is drawn.
  float drawn_m(float depth_m, float near_m) const;
};

/// Of each emitter of an instance at the stage's tick, as `camera` sees them; nothing where it is not called.
/// Waits for the device.
std::vector<EmitterDepths> emitter_depths(const Stage& stage, size_t instance, const CameraKey& camera);

/// The depth curve of a method that slices depth by a logarithm (AVBOIT): its virtual slices end where
/// count log2(1 + z / a) / log2(1 + b / a) is whole.
struct DepthCurve {
  float a, b;
  uint32_t count;

  float slice(float depth_m) const;
  float depth_m(float slice) const;
};

/// What a method cuts depth into.
struct SlicedDepth {
  std::optional<DepthCurve> curve;  ///< of the virtual slices; nothing: it has none
  /// Those that hold something, front to back: what shares one is mixed, empty space lies between.
  std::vector<DepthSlice> physical;

  /// The index among the physical ones; nothing where there is none.
  std::optional<size_t> physical_at(float depth_m) const;
};
/// Of the frame that was drawn with these resources, which decides how many virtual slices there are. Waits
/// for the device.
SlicedDepth sliced_depth(gpu::Device& device, const MethodInstance& drawn);

}  // namespace plume
#endif
