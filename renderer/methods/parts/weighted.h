// Targets and composite of the methods that blend fragments in any order, each weighted by what the method
// believes of its transmittance. Fragment shaders write them with methods/parts/weighted/weighted.glsl, where
// the equation is.
#ifndef PLUME_METHODS_WEIGHTED_H
#define PLUME_METHODS_WEIGHTED_H

#include "renderer/methods/method.h"

namespace plume {

struct Weighted {
  /// Of prod t, which a fragment multiplies. 8 bits stop changing once a fragment takes less than half a
  /// step.
  enum class Revealage { kAsSums, kUnorm8, kHalf, kFloat };

  bool each_channel = false;  ///< a weight and a transmittance for each channel, instead of the mean one
  bool normalise = true;      ///< divide by the sum of the weights
  bool full_floats = false;   ///< 32 bits instead of 16
  Revealage revealage = Revealage::kAsSums;
  bool modulates = false;    ///< the background is multiplied by a target of its own; not with `each_channel`
  uint32_t low_divisor = 1;  ///< of a second set of targets at low resolution; 1: none; nor with those

  /// Images `accum`, `through`, `emission`, `norm` or `modulation`, and the first three with `_low`.
  void add_needs(Needs& needs) const;
  /// All of them, cleared, in the order of the shader's outputs.
  std::vector<gpu::Attachment> targets(const Resources& resources) const;
  std::vector<gpu::Attachment> low_targets(const Resources& resources) const;
  /// The depth that low-resolution things are tested against: the farthest of the pixels they stand for.
  void record_low_depth(const Picture& picture) const;
  const gpu::Image& low_depth(const Resources& resources) const { return resources.image("low_depth"); }
  /// Size of the low-resolution targets, and what share of them the picture fills.
  glm::uvec2 low_size(glm::uvec2 size) const { return (size + low_divisor - 1u) / low_divisor; }
  glm::vec2 low_covered(glm::uvec2 size) const {
    return glm::vec2(size) / glm::vec2(low_size(size) * low_divisor);
  }
  /// What methods/parts/weighted/sums.glsl reads.
  gpu::Bindings sums(const Picture& picture) const;
  /// The pass "resolve", into the picture's result.
  void record_resolve(const Picture& picture) const;
  /// Draws the outputs that the picture wants with `folder`/surface.frag and `folder`/haze.frag.
  void record_outputs(const Picture& picture, const std::string& folder,
                      const gpu::Constants& constants) const;
  /// Pixels whose 16-bit sums overflowed. Waits for the device.
  nlohmann::json statistics(gpu::Device& device, const Resources& resources) const;
};

}  // namespace plume
#endif
