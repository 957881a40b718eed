#include "sandbox/effects/card_kernels.h"

#include <algorithm>

namespace plume {
namespace {

enum class CardKind : uint32_t { kSprites, kMeshes, kRibbons, kPieces };
constexpr std::array kCardShaders{"effects/cards.comp", "effects/cards_mesh.comp",
                                  "effects/cards_ribbon.comp"};

constexpr uint32_t kSourceShift = 30, kKindShift = 28;
constexpr uint32_t kFeatureBits = (1u << kKindShift) - 1;

Source source_of(const Look& look) {
  return look.distortion_deg > 0.0f ? Source::kHaze : plume::source_of(look.transmission);
}

CardKind kind_of(const Look& look) {
  if (look.opaque) return CardKind::kPieces;
  if (look.ribbon) return CardKind::kRibbons;
  return look.meshes.empty() ? CardKind::kSprites : CardKind::kMeshes;
}

CardKind kind_of(uint32_t kernel) {
  return CardKind(kernel >> kKindShift & 3u);
}

}  // namespace

/// What moves a particle is a matter of cards only where no state is kept.
uint32_t card_kernel(const Look& look, uint32_t features) {
  uint32_t drawn = shared::kUsesDisplacement;
  if ((features & shared::kIsAnalytic) != 0)
    drawn |= shared::kIsAnalytic | shared::kUsesPath | shared::kUsesMeshShape;
  return uint32_t(source_of(look)) << kSourceShift | uint32_t(kind_of(look)) << kKindShift |
         (features & drawn);
}

bool makes_pieces(uint32_t kernel) {
  return kind_of(kernel) == CardKind::kPieces;
}

const char* card_shader(uint32_t kernel) {
  return kCardShaders.at(size_t(kind_of(kernel)));
}

uint32_t card_features(uint32_t kernel) {
  return kernel & kFeatureBits;
}

uint32_t threads_a_birth(uint32_t kernel, uint32_t cards_each) {
  return kind_of(kernel) == CardKind::kMeshes ? cards_each : 1;
}

uint32_t cards_of(const SpanList::Kernel& kernel) {
  return kind_of(kernel.id) == CardKind::kRibbons ? 2 * kernel.threads : kernel.threads;
}

std::array<uint32_t, kSources> cards_by_source(const Instances& instances) {
  std::array<uint32_t, kSources> result{};
  for (const EmitterState& emitter : instances.emitters)
    if (emitter.wanted) result[emitter.card_kernel >> kSourceShift] += emitter.cards();
  return result;
}

std::vector<EmitterCards> cards_by_emitter(const Instances& instances) {
  std::vector<EmitterCards> result(instances.emitters.size());
  uint32_t first = 0;
  for (const EmitterState& emitter : instances.emitters) {  // by source; the scene's order is that of calls
    if (!emitter.wanted) continue;
    const CallState& instance = instances.calls[emitter.call];
    const Emitter& described = instances.described(emitter);
    EmitterCards& cards = result[instance.first_emitter + emitter.index];
    cards = {.first = first,
             .count = emitter.cards(),
             .call = emitter.call,
             .emitter = &described,
             .origin = emitter.data.origin,
             .draw_order = instance.call.draw_order + described.look.draw_order};
    first += cards.count;
  }
  std::erase_if(result, [](const EmitterCards& cards) { return cards.count == 0; });
  return result;
}

}  // namespace plume
