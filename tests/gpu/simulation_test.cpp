// Particles are a function of (seed, birth index, tick): every road to a tick gives the same bits.
#include <algorithm>
#include <random>

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class SimulationTest : public GpuTest {
 protected:
  Simulation simulate(const Effect& effect, uint32_t call_tick = 3, uint32_t seed = 5) {
    return Simulation(device, pipelines,
                      {{.name = "test",
                        .effect = &effect,
                        .tick = call_tick,
                        .position = {0.5f, 0.2f, -1.0f},
                        .yaw_deg = 30,
                        .seed = 9}},
                      seed, {0.4f, 0.0f, 0.1f});
  }
  static uint32_t last_tick(const Effect& effect) {
    uint32_t last = 0;
    for (const Emitter& emitter : effect.emitters)
      last = std::max(last, SpawnSchedule(emitter.spawn).last_tick());
    return last;
  }
};

TEST_F(SimulationTest, SteppingAndSeekingGiveTheSameBitsForEveryShippedEffect) {
  std::mt19937 random(1);
  for (const std::string& id : library.ids(PresetKind::kEffect)) {
    const Effect effect = library.effect(id);
    std::vector<uint32_t> ticks;
    std::uniform_int_distribution<uint32_t> any(0, std::min(last_tick(effect) + 20, 1000u));
    for (int i = 0; i < 14; ++i) ticks.push_back(any(random));
    std::ranges::sort(ticks);

    Simulation stepped = simulate(effect), sought = simulate(effect);
    stepped.seek(0);
    size_t compared = 0;
    for (const uint32_t tick : ticks) {
      while (stepped.tick() < tick) stepped.step();
      sought.seek(tick);
      const auto a = stepped.particles(), b = sought.particles();
      ASSERT_EQ(a.size(), b.size()) << id << " at tick " << tick;
      ASSERT_TRUE(std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b))))
          << id << " at tick " << tick;
      compared += a.size();
    }
    if (std::ranges::any_of(effect.emitters, [](const Emitter& e) { return !e.motion.analytic; }))
      EXPECT_GT(compared, 500u) << id << " was hardly compared";
    else
      EXPECT_EQ(compared, 0u) << id << " has no states";
  }
}

TEST_F(SimulationTest, TwoRunsAreEqualAndAnotherSeedIsNot) {
  const Effect effect = library.effect("fireball");
  Simulation a = simulate(effect), b = simulate(effect), other = simulate(effect, 3, 6);
  a.seek(100), b.seek(100), other.seek(100);
  EXPECT_EQ(a.state_hash(), b.state_hash());
  EXPECT_NE(a.state_hash(), other.state_hash());
}

TEST_F(SimulationTest, SeekingBackwardsGivesTheSameBitsAgain) {
  const Effect effect = library.effect("smoke_grenade");
  Simulation simulation = simulate(effect);
  simulation.seek(200);
  const uint64_t before = simulation.state_hash();
  simulation.seek(900);
  EXPECT_NE(before, simulation.state_hash());
  simulation.seek(200);
  EXPECT_EQ(before, simulation.state_hash());
}

TEST_F(SimulationTest, ParticlesAreFiniteAndAliveAsLongAsTheirEmitterSays) {
  const Effect effect = library.effect("fireball");
  Simulation simulation = simulate(effect);
  simulation.seek(60);
  uint32_t longest = 0;
  for (const Emitter& emitter : effect.emitters) longest = std::max(longest, emitter.spawn.life_ticks.max);
  size_t living = 0;
  for (const auto& p : simulation.particles()) {
    const uint32_t age = p.state & shared::kDeadAge;
    if (age == shared::kDeadAge) continue;
    ++living;
    EXPECT_LT(age, longest);
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(p.position[c]));
      EXPECT_LT(std::abs(p.position[c]), 100.0f);
    }
  }
  EXPECT_GT(living, 100u);
}

TEST_F(SimulationTest, WhatIsNotAwakeHasNoMemoryAndNoDispatch) {
  const Effect effect = library.effect("dust");
  Simulation simulation = simulate(effect, 50);
  simulation.seek(10);
  EXPECT_FALSE(simulation.demand()[0].awake);
  EXPECT_EQ("starts at tick 50", simulation.demand()[0].why);
  EXPECT_EQ(0u, simulation.demand()[0].bytes);
  EXPECT_EQ(0u, simulation.demand()[0].dispatches);
  simulation.seek(80);
  EXPECT_TRUE(simulation.demand()[0].awake);
  EXPECT_GT(simulation.demand()[0].bytes, 0u);
  simulation.seek(50 + last_tick(effect) + 1);
  EXPECT_FALSE(simulation.demand()[0].awake);
  EXPECT_EQ(0u, simulation.demand()[0].bytes);
  EXPECT_EQ(1u, simulation.demand()[0].dispatches);
}

}  // namespace
}  // namespace plume
