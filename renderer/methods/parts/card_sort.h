// An order of all cards, sorted on the GPU by keys; most often by the depth of their centres.
#ifndef PLUME_METHODS_CARD_SORT_H
#define PLUME_METHODS_CARD_SORT_H

#include "renderer/methods/method.h"

namespace plume::card_sort {

/// Buffers `pairs`, `scratch`, `counts` and `order`.
void add_needs(Needs& needs, const Transparents& transparents);
/// The pass "sort": leaves all cards in `order`, nearest first; those of one depth as they are in the buffer.
void record(const Picture& picture);

/// The same inside a pass, for at least one card.
void record_by_depth(gpu::Pass& pass, const Picture& picture);
/// Of any (key, card) that stand in `pairs`: leaves the cards in `order`, least key first.
void record_pairs(gpu::Pass& pass, const Picture& picture);

}  // namespace plume::card_sort
#endif
