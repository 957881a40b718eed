#include "sandbox/effects/lineage.h"

namespace plume {

uint32_t births_a_parent(const std::vector<Emitter>& emitters, uint32_t index) {
  const Emitter& emitter = emitters.at(index);
  if (!emitter.parent) return 1;
  const bool is_trail = emitter.look.ribbon && emitter.parent->event == BirthEvent::kLife;
  return emitter.parent->children(emitters.at(emitter.parent->index).spawn.life_ticks.max) + is_trail;
}

Lineage lineage_of(const std::vector<Emitter>& emitters, uint32_t index) {
  Lineage lineage;
  lineage.life = emitters.at(index).spawn.life_ticks.max;
  for (; emitters[index].parent; index = emitters[index].parent->index) {
    lineage.per_root *= births_a_parent(emitters, index);
    lineage.life += emitters.at(emitters[index].parent->index).spawn.life_ticks.max;
    ++lineage.generation;
  }
  lineage.spawn = emitters[index].spawn;
  return lineage;
}

}  // namespace plume
