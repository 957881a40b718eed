// An order of all cards that are seen, sorted on the GPU by keys; most often by the depth of their centres.
#ifndef PLUME_METHODS_CARD_SORT_H
#define PLUME_METHODS_CARD_SORT_H

#include "renderer/methods/method.h"

namespace plume::card_sort {

/// Buffers `pairs`, `scratch`, `counts` and `order`.
void add_needs(Needs& needs, const Transparents& transparents);
/// By view depth, nearest first, those of one depth as they were submitted; or as they are in their buffer.
enum class Key { kDepth, kCard };
/// The pass "sort": leaves the cards in `order`.
void record(const Picture& picture, Key key = Key::kDepth);

/// The same inside a pass.
void record_order(gpu::Pass& pass, const Picture& picture, Key key = Key::kDepth);
/// Of any (key of so many bits, card) that stand in `pairs`, one for each card that is seen: leaves the cards
/// in `order`, least key first.
void record_pairs(gpu::Pass& pass, const Picture& picture, uint32_t bits = 32);

}  // namespace plume::card_sort
#endif
