// Cards that stand where one puts them, on the device: hard cases need depths, coverages and orders that no
// effect gives. Seen from the origin, which looks along -z.
#ifndef PLUME_STRESS_CARD_STAGE_H
#define PLUME_STRESS_CARD_STAGE_H

#include <array>
#include <vector>

#include "renderer/frame.h"
#include "renderer/seen_cards.h"
#include "sandbox/scene/opaque.h"
#include "shaders/effects/puff.h"
#include "shaders/shared/card.h"
#include "shaders/shared/view.h"

namespace plume {

struct PlacedCard {
  double z = 5.0;  ///< view depth of its middle, m
  float optical_depth = 0.5f;
  glm::vec3 color{0.0f}, transmission{0.0f}, emission{0.0f};
  glm::vec2 half_size{1e3f};  ///< m
  glm::vec2 at{0.0f};         ///< of its middle, m right and up
  float yaw = 0.0f, pitch = 0.0f;
  uint32_t layer = shared::kSoftLayer;  ///< or kSolidLayer: sharp, as glass and discs are to methods that ask
  bool apart = false;
};

shared::Card make_card(const PlacedCard& card);

struct CardsBySource {
  std::array<std::vector<shared::Card>, kSources> sources;
  std::vector<uint32_t> order;  ///< of all cards, one source after the other; empty: as they are
};

/// The optical depth that covers so much; 1 is the largest there is.
float optical_depth_of(double coverage);

struct CardScene {
  std::vector<PlacedCard> cards;
  glm::vec3 background{0.0f};
  std::vector<Solid> solids;
  float near_m = 0.1f, far_m = 500.0f, vertical_fov_deg = 50.0f;
  bool puffs = false;  ///< smoke thins towards its edges; otherwise it is as dense there as in its middle
  /// So many more smooth sprites of a hundredth of a pixel, all in the tile of 8 x 8 pixels that holds the
  /// picture's middle: as many of them as a buffer of the device holds.
  uint32_t crowd = 0;
  uint32_t order = 0;  ///< 0: drawn as they stand in the list; otherwise shuffled, each number another way
};

class CardStage {
 public:
  /// Of cards as dense everywhere as in their middle.
  CardStage(gpu::Device& device, gpu::Pipelines& pipelines, const std::vector<Solid>& solids,
            const shared::ViewData& view, CardsBySource cards);
  CardStage(gpu::Device& device, gpu::Pipelines& pipelines, const CardScene& scene, glm::uvec2 size);
  CardStage(const CardStage&) = delete;  // transparents() points into it

  Prelude prelude() const;
  const Transparents& transparents() const { return transparents_; }
  const gpu::Image& texture() const { return texture_; }

 private:
  OpaqueScene opaque_;
  gpu::Image texture_;
  gpu::Buffer view_, cards_, order_;
  SeenCards seen_;
  Transparents transparents_;
};

}  // namespace plume
#endif
