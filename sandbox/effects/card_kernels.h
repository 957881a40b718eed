// Which kernel turns an emitter's particles into cards, and which cards are whose.
#ifndef PLUME_EFFECTS_CARD_KERNELS_H
#define PLUME_EFFECTS_CARD_KERNELS_H

#include <array>

#include "renderer/transparents.h"
#include "sandbox/effects/instances.h"
#include "sandbox/effects/span_list.h"

namespace plume {

/// Kernels in the order in which cards lie: those of one source stand together.
///   source << kSourceShift | kind << kKindShift | features
/// `features` are those of its motion.
uint32_t card_kernel(const Look& look, uint32_t features);

/// Pieces are opaque meshes, which are drawn themselves: their kernel has no shader.
bool makes_pieces(uint32_t kernel);
const char* card_shader(uint32_t kernel);
/// Its specialisation constant 0.
uint32_t card_features(uint32_t kernel);
/// A mesh's faces are shared out; a ribbon's segment and all else are a thread's.
uint32_t threads_a_birth(uint32_t kernel, uint32_t cards_each);
/// That a dispatch writes.
uint32_t cards_of(const SpanList::Kernel& kernel);

/// Cards of those awake, by source, in the order of the enumeration, which is also that of the cards.
std::array<uint32_t, kSources> cards_by_source(const Instances& instances);

struct EmitterCards {
  uint32_t first, count;
  uint32_t call;  ///< which of the calls
  const Emitter* emitter;
  glm::vec3 origin;  ///< of the emitter, world
  int draw_order;
};
/// The same by emitter, in the order of calls and of their emitters.
std::vector<EmitterCards> cards_by_emitter(const Instances& instances);

}  // namespace plume
#endif
