#include "sandbox/scene/card_owner.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace plume {
namespace {

/// Of those that go into one source of cards, the `index`-th.
uint32_t pane_of(const Scene& scene, Source source, uint32_t index) {
  for (uint32_t pane = 0; pane < scene.panes.size(); ++pane)
    if (source_of(scene.panes[pane].transmission) == source && index-- == 0) return pane;
  throw std::out_of_range("a card that is no pane's");
}

const EmitterState& state_of(const Instances& instances, const EmitterCards& cards) {
  const auto& described = instances.calls[cards.call].described();
  return instances.emitter_of(cards.call, uint32_t(cards.emitter - described.data()));
}

CardOwner particle_of(const Instances& instances, const EmitterState& emitter, uint32_t index,
                      uint32_t part) {
  const Call& call = instances.calls[emitter.call].call;
  return {.pane = {},
          .effect = call.effect->id,
          .instance = call.name,
          .emitter = instances.described(emitter).name,
          .birth = uint32_t(emitter.schedule.first_alive(*emitter.wanted)) + index,
          .part = part};
}

CardOwner owner_of_piece(const Instances& instances, uint32_t piece) {
  for (const EmitterState& emitter : instances.emitters) {
    if (!emitter.wanted || !makes_pieces(emitter.card_kernel)) continue;
    if (piece < emitter.living()) return particle_of(instances, emitter, piece, 0);
    piece -= emitter.living();
  }
  throw std::out_of_range("a piece that is nobody's");
}

}  // namespace

std::string to_text(const CardOwner& owner) {
  if (owner.pane) return fmt::format("pane {}", *owner.pane);
  const std::string instance =
      owner.instance == owner.effect ? owner.effect : fmt::format("{} ({})", owner.effect, owner.instance);
  return fmt::format("{} / {} #{}", instance, owner.emitter, owner.birth);
}

// As Stage lays them out: panes, the simulation's cards, panes that pass some colours better than others.
CardOwner owner_of(const Stage& stage, uint32_t card) {
  const Scene& scene = stage.scene();
  const uint32_t scalar_panes = uint32_t(std::ranges::count_if(
      scene.panes, [](const Pane& pane) { return source_of(pane.transmission) == Source::kScalar; }));
  const uint32_t simulated = stage.simulation().cards();
  const Instances& instances = stage.simulation().instances();
  if (const uint32_t cards = stage.transparents().count; card >= cards)
    return owner_of_piece(instances, card - cards);
  if (card < scalar_panes) return {.pane = pane_of(scene, Source::kScalar, card)};
  if (card - scalar_panes >= simulated)
    return {.pane = pane_of(scene, Source::kRgb, card - scalar_panes - simulated)};

  const uint32_t index = card - scalar_panes;
  for (const EmitterCards& cards : cards_by_emitter(instances)) {
    if (index - cards.first >= cards.count) continue;
    const EmitterState& emitter = state_of(instances, cards);
    const uint32_t each = emitter.data.cards_each, of_emitter = index - cards.first;
    return particle_of(instances, emitter, of_emitter / each, of_emitter % each);
  }
  throw std::out_of_range("a card that is nobody's");
}

}  // namespace plume
