// A scene on the GPU at a tick: what stands, what moves, and what the renderer draws of it.
#ifndef PLUME_SCENE_STAGE_H
#define PLUME_SCENE_STAGE_H

#include "renderer/frame.h"
#include "sandbox/effects/lighting.h"
#include "sandbox/presets/library.h"
#include "sandbox/scene/opaque.h"
#include "shaders/shared/card.h"

namespace plume {

class Stage {
 public:
  /// Reads the effects the scene calls. Throws what the library throws, and DeviceFailure.
  Stage(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, Scene scene);
  Stage(const Stage&) = delete;  // transparents() points into it

  /// Simulates to `tick` and looks from `camera` (nothing: the scene's own).
  std::vector<gpu::PassTime> go_to(uint32_t tick, glm::uvec2 size, std::optional<CameraKey> camera = {});
  /// Passes that come before the method's: cards from particles, the opaque image.
  Prelude prelude() const;
  const Transparents& transparents() const { return transparents_; }
  /// What the scene asks to be done to its picture.
  Post post() const;

  /// The order in which cards are drawn: a permutation of 0 .. transparents().count - 1.
  /// Within each source: sources stay together. Reset by go_to().
  void set_draw_order(const std::vector<uint32_t>& order);

  const Scene& scene() const { return scene_; }
  const Simulation& simulation() const { return *simulation_; }
  const Lighting& lighting() const { return *lighting_; }
  /// Called and uncalled instances, in the order of the scene.
  std::vector<InstanceDemand> demand() const;

 private:
  void fit_cards(uint32_t count);
  std::vector<CardGroup> card_groups() const;

  gpu::Device& device_;
  Scene scene_;
  std::map<std::string, Effect> effects_;
  gpu::Image puffs_;
  OpaqueScene opaque_;
  std::optional<Simulation> simulation_;
  std::optional<Lighting> lighting_;
  std::vector<shared::Card> scalar_panes_, rgb_panes_;
  gpu::Buffer view_, cards_, order_;
  uint32_t capacity_ = 0;
  bool in_order_ = false;  ///< order_ is the identity over the whole capacity
  Transparents transparents_;
};

}  // namespace plume
#endif
