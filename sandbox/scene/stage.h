// A scene on the GPU at a tick: what stands, what moves, and what the renderer draws of it.
#ifndef PLUME_SCENE_STAGE_H
#define PLUME_SCENE_STAGE_H

#include <functional>
#include <memory>

#include "renderer/frame.h"
#include "renderer/seen_cards.h"
#include "sandbox/effects/lighting.h"
#include "sandbox/presets/library.h"
#include "sandbox/scene/opaque.h"
#include "sandbox/scene/scene_edits.h"
#include "shaders/shared/card.h"

namespace plume {

class Stage {
 public:
  /// Reads the effects the scene calls, but for those in `edits`. Throws what the library throws, and
  /// DeviceFailure. `library` outlives the stage.
  Stage(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, Scene scene,
        const SceneEdits& edits = {});
  Stage(const Stage&) = delete;  // transparents() points into it

  /// Takes other edits instead of those it has. What an edit touches is sought anew by the next go_to(), to
  /// the same bits as in a stage made with them. Throws FileErrors when the scene cannot bear them, and
  /// leaves everything as it was.
  void revise(const SceneEdits& edits);
  /// Shows another scene, which may differ from the one it has in its instances and its names alone;
  /// likewise. Instances are known by their names. Throws what the library throws, too.
  void revise(Scene scene, const SceneEdits& edits);

  /// Simulates to `tick` and looks from `camera` (nothing: the scene's own).
  std::vector<gpu::PassTime> go_to(uint32_t tick, glm::uvec2 size, std::optional<CameraKey> camera = {});
  /// Forgets all ticks and what they took: the next go_to() is as that of a stage just made.
  void start_over() { simulation_->start_over(); }
  /// Passes that come before the method's: cards from particles, the opaque image.
  Prelude prelude() const;
  const Transparents& transparents() const { return transparents_; }
  /// What the last frame that was drawn left out: see scene/bad_particles.h.
  shared::BadCards bad_cards() const { return seen_.bad(); }
  /// What the scene asks to be done to its picture.
  Post post() const;

  /// Whether what is seen at a tick may depend on what was looked at before: some effect pauses out of view.
  bool remembers() const;

  /// The order in which cards are drawn: a permutation of 0 .. transparents().count - 1.
  /// Within each source: sources stay together. Reset by go_to().
  void set_draw_order(const std::vector<uint32_t>& order);

  const Scene& scene() const { return scene_; }
  /// With what is muted and frozen: a stage made of this one shows the same.
  const Scene& played() const { return played_; }
  /// Those that are called or muted, by what the scene calls them.
  const std::map<std::string, Effect>& effects() const { return effects_; }
  const Simulation& simulation() const { return *simulation_; }
  const Lighting& lighting() const { return *lighting_; }
  /// Called and uncalled instances, in the order of the scene.
  std::vector<InstanceDemand> demand() const;
  /// Which of the simulation's calls an instance of the scene is; nothing: it is not called, or muted.
  std::optional<uint32_t> call_of(size_t instance) const { return call_of_[instance]; }

 private:
  std::map<std::string, Effect> effects_with(const SceneEdits& edits);
  std::vector<std::optional<uint32_t>> calls_by_name(const std::vector<Instance>& others) const;
  void call_effects(std::map<std::string, Effect> effects, const SceneEdits& edits,
                    const std::vector<std::optional<uint32_t>>& was);
  bool plays(const std::function<bool(const Effect&)>& which) const;
  void fit_cards(uint32_t count);
  std::vector<CardGroup> card_groups() const;

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  const PresetLibrary& library_;
  Scene scene_, played_;
  std::map<std::string, Effect> from_library_, effects_;  ///< by the name that the scene calls them
  std::vector<std::optional<uint32_t>> call_of_;
  gpu::Image puffs_;
  OpaqueScene opaque_;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<Lighting> lighting_;
  std::vector<shared::Card> scalar_panes_, rgb_panes_;
  gpu::Buffer view_, cards_;
  gpu::Buffer submission_;  ///< a permutation of the cards
  SeenCards seen_;
  uint32_t capacity_ = 0;
  bool in_order_ = false;  ///< `submission_` is the identity over the whole capacity
  Transparents transparents_;
};

}  // namespace plume
#endif
