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
  if (card < scalar_panes) return {.pane = pane_of(scene, Source::kScalar, card)};
  if (card - scalar_panes >= simulated)
    return {.pane = pane_of(scene, Source::kRgb, card - scalar_panes - simulated)};

  const uint32_t index = card - scalar_panes;
  const Instances& instances = stage.simulation().instances();
  for (const EmitterCards& cards : cards_by_emitter(instances)) {
    if (index - cards.first >= cards.count) continue;
    const CallState& call = instances.calls[cards.call];
    const auto& described = call.described();
    const EmitterState& emitter =
        instances.emitter_of(cards.call, uint32_t(cards.emitter - described.data()));
    const uint32_t each = emitter.data.cards_each, of_emitter = index - cards.first;
    return {.pane = {},
            .effect = call.call.effect->id,
            .instance = call.call.name,
            .emitter = cards.emitter->name,
            .birth = uint32_t(emitter.schedule.first_alive(*emitter.wanted)) + of_emitter / each,
            .part = of_emitter % each};
  }
  throw std::out_of_range("a card that is nobody's");
}

}  // namespace plume
