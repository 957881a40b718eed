// A particle's whole life, tick by tick: born by its emitter, or of a parent whose life it follows until the event that bears it.
// A slot of a child carries its parent's motion until then (and, two levels deep, its parent's parent's before), so where a child is
// born needs nobody else's state, and its slot is a function of (seed, birth index, tick) like any other.
//   birth index of a child = birth index of its parent * children a parent + which of them
#ifndef PLUME_EFFECTS_LINEAGE_GLSL
#define PLUME_EFFECTS_LINEAGE_GLSL
#include "effects/path.glsl"
#include "effects/shapes.glsl"
#include "effects/spans.glsl"
#include "effects/step.glsl"

// What a slot carries at a tick.
struct Life {
  Motion motion;
  uint age;          // ticks; kDeadAge: nothing lives here any more
  uint generation;   // ancestors still to come: 0 = the particle itself
};

// Who a slot carries `generation` generations above its own particle.
struct Kin {
  uint emitter;
  uint birth;
  uint child;     // emitter of the next generation
  uint sibling;   // which child of that emitter is meant
};

Kin kin_of(uint emitter, uint birth, uint generation) {
  Kin kin = Kin(emitter, birth, emitter, 0u);
  if ((kFeatures & kUsesLineage) != 0u)
    for (uint g = 0u; g < generation; ++g) {
      const uint siblings = emitters[kin.emitter].per_parent;
      kin = Kin(emitters[kin.emitter].parent, kin.birth / siblings, kin.emitter, kin.birth % siblings);
    }
  return kin;
}

bool bears(EmitterData child, uint sibling, Life parent, bool dies) {
  switch (child.birth_event) {
    case kBornOfLife: return parent.age >= child.birth_first + sibling * child.birth_every;
    case kBornOfDeath: return dies;
    case kBornOfCollision: return collisions(parent.motion) > sibling / child.birth_count;
    default: return true;
  }
}

// Apart from its use: `precise` on what a struct in a loop is made of sends glslang 12 into an endless search.
vec3 share_of(float share, vec3 velocity) {
  precise vec3 result = share * velocity;
  return result;
}

// Hands the slot over to the child whose hour has come, which may hand it over at once; otherwise the dead leave it.
Life settle(Life life, uint emitter, uint birth, bool dies) {
  if ((kFeatures & kUsesLineage) != 0u)
    for (uint g = 0u; g < kMostGenerations && life.generation > 0u; ++g) {
      const Kin kin = kin_of(emitter, birth, life.generation);
      const EmitterData child = emitters[kin.child];
      if (!bears(child, kin.sibling, life, dies)) break;
      const Kin next = kin_of(emitter, birth, life.generation - 1u);
      const vec3 inherited = share_of(child.inherit_velocity, life.motion.velocity);
      life.motion = birth_motion(child, particle_key(child, next.birth), life.motion.position, inherited);
      life.age = 0u;
      life.generation -= 1u;
      dies = false;
    }
  if (dies) life.age = kDeadAge;
  return life;
}

// `tick` is the emitter's own, since the call; `part` of it had passed.
Life first_life(uint emitter, uint birth, uint tick, float part) {
  const uint generation = (kFeatures & kUsesLineage) != 0u ? emitters[emitter].generation : 0u;
  const Kin kin = kin_of(emitter, birth, generation);
  const EmitterData e = emitters[kin.emitter];
  const Motion m = birth_motion(e, particle_key(e, kin.birth), origin_at(e, float(tick) - 1.0 + part), vec3(0.0));
  return settle(Life(m, 0u, generation), emitter, birth, false);
}

// From `tick` to the next. `own` is the emitter's: read once, not at each tick, where no ancestor can be who the slot carries.
Life advance(Life life, EmitterData own, uint emitter, uint birth, uint tick) {
  const Kin kin = kin_of(emitter, birth, life.generation);
  EmitterData e = own;
  if ((kFeatures & kUsesLineage) != 0u) e = emitters[kin.emitter];
  life.motion = step_motion(e, origin_at(e, float(tick)), life.motion, life.age, tick);
  life.age += 1u;
  const bool dies = life.age >= life_of(e, particle_key(e, kin.birth)) || (life.motion.contact & kKilled) != 0u;
  return settle(life, emitter, birth, dies);
}

// What a slot holds once its particle has died is the same whichever road led there.
Particle particle_of(Life life, uint birth) {
  if (life.age == kDeadAge) return Particle(vec3(0.0), birth, vec3(0.0), kDeadAge);
  const uint word = life.age | life.motion.contact << kContactShift | life.generation << kGenerationShift;
  return Particle(life.motion.position, birth, life.motion.velocity, word);
}

Life life_in(Particle p) {
  return Life(Motion(p.position, p.velocity, contact_of(p)), age_of(p), generation_of(p));
}

#endif
