// Children: born of other particles, at their birth, in their life, at their death, where they collide.
#include "sandbox/effects/lineage.h"

#include <random>

#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

class LineageTest : public MovingParticles {
 protected:
  static constexpr uint32_t kParents = 20;
  /// Thrown up with a life of its own each, onto the ground.
  static Emitter parents() {
    Emitter e = emitter(kParents);
    e.name = "parents";
    e.spawn.life_ticks = {60, 120};
    e.motion.speed = {1, 4};
    e.motion.velocity = {0.5f, 2, 0};
    e.motion.gravity = 1;
    e.motion.collision = Collision{.response = CollisionResponse::kBounce, .bounce = 0.5f, .radius_m = 0.02f};
    return e;
  }
  /// They stay where they are born unless told otherwise.
  static Emitter children(const std::string& name, Parent parent) {
    Emitter e;
    e.name = name;
    e.spawn.life_ticks = {40, 40};
    e.look.cross_section_m2 = 0.1f;
    e.parent = std::move(parent);
    return e;
  }
  static Place place() {
    return {.origin = {0, 1, 0}, .solids = {{.kind = SolidKind::kPlane, .size_m = {50, 0, 50}}}};
  }
  /// By birth; of the emitter with this index, each emitter's following the one's before.
  struct States {
    std::vector<shared::Particle> parents, children;
  };
  States at(Simulation& simulation, uint32_t tick) {
    simulation.seek(tick);
    States states;
    const auto cards = cards_by_emitter(simulation.instances());  // of those with any
    const uint32_t parents = cards.size() == 2 ? cards[0].count : 0;
    for (const auto& p : simulation.particles())
      (states.parents.size() < parents ? states.parents : states.children).push_back(p);
    return states;
  }
  static uint32_t age(const shared::Particle& p) { return p.state & shared::kDeadAge; }
  static bool is_born(const shared::Particle& p) { return p.state >> shared::kGenerationShift == 0; }
  static bool is_new(const shared::Particle& p) { return is_born(p) && age(p) == 0; }
};

TEST_F(LineageTest, ChildrenOfALifeComeOneByOneWhereTheirParentIs) {
  const Effect effect = effect_of({parents(), children("trail", {.emitter = "parents",
                                                                 .index = 0,
                                                                 .event = BirthEvent::kLife,
                                                                 .first_tick = 6,
                                                                 .every_ticks = 4})});
  Simulation simulation = simulate(effect, place());
  uint32_t born = 0;
  const uint32_t each = effect.emitters[1].parent->children(120);
  EXPECT_EQ(29u, each) << "at ages 6, 10, ... 118";
  for (uint32_t tick = 0; tick < 100; ++tick) {
    const States states = at(simulation, tick);
    ASSERT_EQ(kParents * each, states.children.size());
    for (uint32_t c = 0; c < states.children.size(); ++c) {
      if (!is_new(states.children[c])) continue;
      const auto& parent = states.parents[c / each];
      if (is_dead(parent)) continue;  // due just then: it is born in its parent's last place
      EXPECT_EQ(6 + 4 * (c % each), age(parent));
      EXPECT_EQ(parent.position, states.children[c].position);
      ++born;
    }
  }
  EXPECT_GT(born, kParents * 14u);
}

TEST_F(LineageTest, ChildrenOfADeathAreBornWhereAndWhenTheirParentDies) {
  const Effect effect = effect_of(
      {parents(),
       children("burst", {.emitter = "parents", .index = 0, .event = BirthEvent::kDeath, .count = 3})});
  Simulation simulation = simulate(effect, place());
  States before = at(simulation, 0);
  uint32_t born = 0;
  for (uint32_t tick = 1; tick < 125; ++tick) {
    const States states = at(simulation, tick);
    for (uint32_t c = 0; c < states.children.size(); ++c) {
      if (!is_new(states.children[c])) continue;
      ++born;
      if (!before.parents.empty()) {
        EXPECT_FALSE(is_dead(before.parents[c / 3]));
        EXPECT_LT(glm::distance(before.parents[c / 3].position, states.children[c].position), 0.2f);
      }
      if (!states.parents.empty()) {
        EXPECT_TRUE(is_dead(states.parents[c / 3]));
      }
    }
    before = states;
  }
  EXPECT_EQ(3 * kParents, born) << "each parent bears once";
}

TEST_F(LineageTest, ChildrenOfCollisionsAreBornOnTheGround) {
  const Effect effect = effect_of({parents(), children("splash", {.emitter = "parents",
                                                                  .index = 0,
                                                                  .event = BirthEvent::kCollision,
                                                                  .count = 2,
                                                                  .collisions = 2})});
  Simulation simulation = simulate(effect, place());
  uint32_t born = 0;
  for (uint32_t tick = 0; tick < 125; ++tick)
    for (const auto& child : at(simulation, tick).children)
      if (is_new(child)) {
        ++born;
        EXPECT_LT(child.position.y, 0.15f) << "not far from its bounce";
      }
  EXPECT_GT(born, 2 * kParents);
  EXPECT_LE(born, 4 * kParents);
}

TEST_F(LineageTest, ChildrenOfABirthInheritAShareOfTheirParentsVelocity) {
  Emitter child = children(
      "pair",
      {.emitter = "parents", .index = 0, .event = BirthEvent::kBirth, .count = 2, .inherit_velocity = 0.5f});
  const Effect effect = effect_of({parents(), child});
  Simulation simulation = simulate(effect, place());
  const States states = at(simulation, 0);
  ASSERT_EQ(2 * kParents, states.children.size());
  for (uint32_t c = 0; c < states.children.size(); ++c) {
    EXPECT_TRUE(is_new(states.children[c]));
    EXPECT_EQ(states.parents[c / 2].position, states.children[c].position);
    EXPECT_EQ(0.5f * states.parents[c / 2].velocity, states.children[c].velocity);
  }
}

TEST_F(LineageTest, TwoGenerationsStepAndSeekToTheSameBits) {
  Emitter trail = children("trail", {.emitter = "parents",
                                     .index = 0,
                                     .event = BirthEvent::kLife,
                                     .every_ticks = 7,
                                     .inherit_velocity = 0.3f});
  trail.spawn.life_ticks = {20, 50};
  trail.motion.gravity = 0.5f;
  trail.motion.curl = {.strength = 3, .octaves = 2};
  Emitter puffs =
      children("puffs", {.emitter = "trail", .index = 1, .event = BirthEvent::kDeath, .count = 2});
  puffs.motion.speed = {0.1f, 0.4f};
  Emitter roots = parents();
  roots.spawn.bursts = {{0, 8}, {11, 5}};
  roots.spawn.rate = {{5, 30}, {90, 60}};
  roots.motion.kill = {{.kind = KillVolume::Kind::kSphere, .radius_m = 3, .outside = true}};
  const Effect effect = effect_of({roots, trail, puffs});
  EXPECT_EQ(2u, lineage_of(effect.emitters, 2).generation);
  EXPECT_EQ(18u * 2, lineage_of(effect.emitters, 2).per_root);
  Simulation stepped = simulate(effect, place()), sought = simulate(effect, place());
  stepped.seek(0);
  uint32_t grandchildren = 0;
  for (const uint32_t tick : {1u, 2u, 9u, 40u, 77u, 130u, 200u, 259u, 300u}) {
    while (stepped.tick() < tick) stepped.step();
    sought.seek(tick);
    ASSERT_EQ(stepped.state_hash(), sought.state_hash()) << "tick " << tick;
    const auto cards = cards_by_emitter(sought.instances());
    const auto particles = sought.particles();
    if (cards.size() == 3)
      for (size_t i = particles.size() - cards[2].count; i < particles.size(); ++i)
        grandchildren += is_born(particles[i]) && !is_dead(particles[i]);
  }
  EXPECT_GT(grandchildren, 50u);
  stepped.seek(400);
  EXPECT_FALSE(stepped.demand()[0].awake) << stepped.demand()[0].why;
}

TEST_F(LineageTest, AMovingInstanceBearsAlongItsPath) {
  Emitter e = emitter(0);
  e.spawn.bursts = {};
  e.spawn.per_metre = 10;
  const Effect effect = effect_of({e});
  const Path path({{10, {0, 2, 0}}, {40, {3, 2, 0}}, {70, {6, 2, 0}}});
  Simulation simulation(device, pipelines,
                        {{.name = "test",
                          .effect = &effect,
                          .tick = 0,
                          .position = {1, 0, 0},
                          .path = path,
                          .yaw_deg = 0,
                          .seed = 1}},
                        1, {});
  simulation.seek(200);
  const auto particles = simulation.particles();
  ASSERT_EQ(60u, particles.size());
  for (uint32_t i = 0; i < 60; ++i) {
    EXPECT_NEAR(1 + 0.05 + 0.1 * i, particles[i].position.x, 0.051) << i;
    EXPECT_EQ(2.0f, particles[i].position.y);
  }
}

}  // namespace
}  // namespace plume
