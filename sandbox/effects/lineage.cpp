#include "sandbox/effects/lineage.h"

namespace plume {

Lineage lineage_of(const std::vector<Emitter>& emitters, uint32_t index) {
  const Emitter* emitter = &emitters.at(index);
  Lineage lineage;
  lineage.life = emitter->spawn.life_ticks.max;
  for (; emitter->parent; emitter = &emitters.at(emitter->parent->index)) {
    const uint32_t of_parent = emitters.at(emitter->parent->index).spawn.life_ticks.max;
    lineage.per_root *= emitter->parent->children(of_parent);
    lineage.life += of_parent;
    ++lineage.generation;
  }
  lineage.spawn = emitter->spawn;
  return lineage;
}

}  // namespace plume
