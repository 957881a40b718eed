// Emitters whose particles are born of other particles: how many a root bears, and how long all of that
// lives.
#ifndef PLUME_EFFECTS_LINEAGE_H
#define PLUME_EFFECTS_LINEAGE_H

#include "sandbox/effects/effect.h"

namespace plume {

/// Of one emitter: the ancestor with a rate, and what each of its births leads to.
struct Lineage {
  Spawn spawn;              ///< of that root
  uint64_t per_root = 1;    ///< particles of the emitter for each birth of the root
  uint32_t life = 0;        ///< ticks at most from such a birth to the end of all of it
  uint32_t generation = 0;  ///< ancestors above
};

/// Births for each of its parent. A trail, which is a ribbon of children of a life, has one more than are
/// born before the longest life ends: while the parent lives there is always one to come, who is its head.
uint32_t births_a_parent(const std::vector<Emitter>& emitters, uint32_t index);

/// Parents stand before their children in `emitters`, as the reader makes sure.
Lineage lineage_of(const std::vector<Emitter>& emitters, uint32_t index);

}  // namespace plume
#endif
