// Light on effects, and the light and shadow that effects cast: an extinction volume seen from the sun, one
// seen from the zenith, and one light a fire. See shaders/effects/light_volume.glsl for the equations and
// limits. What no awake emitter calls for has no passes and no memory.
#ifndef PLUME_EFFECTS_LIGHTING_H
#define PLUME_EFFECTS_LIGHTING_H

#include "sandbox/effects/simulation.h"
#include "shaders/shared/light.h"

namespace plume {

/// Emitters whose particles are wide enough that their shadow is seen. Flat colours, haze, meshes and ribbons
/// cast none.
bool casts_shadow(const Look& look);
/// Emitters that are a light to others. Opaque pieces are none.
bool glows(const Look& look);

/// What a scene asks for.
struct LightingOptions {
  bool self_shadow = true;
  uint32_t cells = 48;     ///< of the sun's volume, each way; the sky's has half of them
  float fire_gain = 1.0f;  ///< 0: fires are no lights
};

class Lighting {
 public:
  /// `glowing` are the places of all calls with an emitter that glows, by call: fires near each other share a
  /// light when there are more than kMostFires.
  Lighting(gpu::Device& device, LightingOptions options, const std::map<uint32_t, glm::vec3>& glowing);

  /// To be called when the tick has changed. Makes or frees what this tick's emitters call for.
  void fit(const std::vector<EmitterCards>& emitters, uint32_t cards);

  /// Null: light asks for nothing at this tick.
  const gpu::Buffer* bodies() const { return bodies_ ? &bodies_ : nullptr; }
  bool shadows() const { return volumes_are_ == Volumes::kFull; }
  uint32_t fires() const { return fire_count_; }

  /// After the cards and bodies of this tick, and after it is known which are seen; nothing when light asks
  /// for nothing. `first_card`: where in the buffer of cards those with bodies begin.
  void record(gpu::Frame& frame, const Transparents& seen, uint32_t first_card) const;
  /// What shaders/effects/light_volume.glsl reads; only with bodies().
  gpu::Bindings bindings() const;

  // For tests and the debugger: shared::LightGrid[kLightGrids]; FireLight[] after a padded count.
  const gpu::Buffer& grids() const { return grids_; }
  const gpu::Image& volume(uint32_t grid) const { return volumes_[grid]; }
  const gpu::Buffer& fire_lights() const { return fires_; }

 private:
  enum class Volumes { kNone, kEmpty, kFull };
  void fit_volumes(Volumes wanted);
  void fit_fires(const std::vector<EmitterCards>& emitters);
  void record_volumes(gpu::Frame& frame, const gpu::Buffer& view) const;

  gpu::Device& device_;
  LightingOptions options_;
  std::array<uint32_t, shared::kLightGrids> cells_each_way_;
  std::map<uint32_t, uint32_t> fire_of_call_;
  uint32_t count_ = 0, fire_count_ = 0;
  bool receives_ = false;
  Volumes volumes_are_ = Volumes::kNone;
  gpu::Buffer bodies_, bounds_, grids_, fires_, sources_, ranges_;
  std::array<gpu::Buffer, shared::kLightGrids> cells_;
  std::array<gpu::Image, shared::kLightGrids> volumes_;  ///< two texels where fires burn and nothing casts
};

}  // namespace plume
#endif
