// Targets and composite of the methods that blend fragments in any order, each weighted by what the method
// believes of its transmittance. Fragment shaders write them with methods/weighted/weighted.glsl, where the
// equation is.
#ifndef PLUME_METHODS_WEIGHTED_H
#define PLUME_METHODS_WEIGHTED_H

#include "renderer/methods/method.h"

namespace plume {

struct Weighted {
  bool each_channel = false;  ///< a weight and a transmittance for each channel, instead of the mean one
  bool normalise = true;      ///< divide by the sum of the weights
  bool full_floats = false;   ///< 32 bits instead of 16

  /// Images `accum`, `through`, `emission`, `norm`.
  void add_needs(Needs& needs) const;
  /// All of them, cleared, in the order of the shader's outputs.
  std::vector<gpu::Attachment> targets(const Resources& resources) const;
  /// The pass "resolve", into the picture's result.
  void record_resolve(const Picture& picture) const;
};

}  // namespace plume
#endif
