// What many instances share, a dispatch and tables, changes nothing of theirs and takes little memory.
#include <cstring>

#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

class ManyInstances : public MovingParticles {
 protected:
  static Call call_of(const Effect& effect, uint32_t i) {
    return {.name = std::to_string(i),
            .effect = &effect,
            .tick = 0,
            .position = {0.1f * float(i), 0, 0},
            .yaw_deg = 0,
            .seed = i};
  }
  Simulation simulate(const std::vector<Call>& calls) {
    return Simulation(device, pipelines, calls, 1, {0.3f, 0, 0});
  }
  static Emitter drifting(uint32_t count) {
    Emitter e = emitter(count);
    e.motion.speed = {0.5f, 1};
    e.motion.drag = 1;
    return e;
  }
  uint64_t table_bytes() { return device.memory().owner_bytes("simulation"); }
};

/// Work groups have 64 threads: instances end before, at and behind their edges, and some groups serve many.
TEST_F(ManyInstances, ParticlesAreTheSameAmongThemAsAlone) {
  const std::vector<uint32_t> counts{1, 63, 64, 64, 65, 128, 3, 300, 61, 7};
  std::vector<Effect> effects;
  for (uint32_t i = 0; i < 100; ++i) {
    const uint32_t count = i < counts.size() ? counts[i] : i % 5;
    effects.push_back(effect_of({drifting(count)}));
    effects.back().emitters[0].spawn.rate = {{0, 20}, {10'000, 20}};  // births come in between
    effects.back().emitters[0].spawn.life_ticks = {6, 9};
    if (i % 3 == 0) effects.back().emitters[0].motion.curl = {.strength = 1};  // another kernel
  }
  std::vector<Call> calls;
  for (uint32_t i = 0; i < effects.size(); ++i) calls.push_back(call_of(effects[i], i));
  Simulation stepped = simulate(calls), sought = simulate(calls);
  stepped.seek(0);
  for (int i = 0; i < 7; ++i) stepped.step();
  sought.seek(7);
  std::vector<shared::Particle> alone;
  for (const Call& call : calls) {
    Simulation one = simulate({call});
    one.seek(7);
    for (const shared::Particle& particle : one.particles()) alone.push_back(particle);
  }
  ASSERT_GT(alone.size(), 800u);
  for (const Simulation* many : {&stepped, &sought}) {
    const auto together = many->particles();
    ASSERT_EQ(alone.size(), together.size());
    for (size_t i = 0; i < alone.size(); ++i)
      ASSERT_EQ(0, std::memcmp(&alone[i], &together[i], sizeof alone[i])) << "particle " << i;
  }
}

TEST_F(ManyInstances, AParticleTakes32BytesAndAThirdOfAByteOfTables) {
  static_assert(sizeof(shared::Particle) == 32);
  uint64_t tables[2];
  const uint32_t counts[] = {100'000, 200'000};
  for (int i = 0; i < 2; ++i) {
    const Effect effect = effect_of({drifting(counts[i])});
    Simulation simulation = simulate({call_of(effect, 0)});
    simulation.seek(0);
    simulation.step();
    EXPECT_EQ(32ull * counts[i], device.memory().owner_bytes("particles"));
    tables[i] = table_bytes();
  }
  // Where each work group's span is, in three lists, with half as much room again: 3 * 1.5 * 4 / 64.
  EXPECT_LE(double(tables[1] - tables[0]) / (counts[1] - counts[0]), 0.3);
}

TEST_F(ManyInstances, AnEmitterTakesItsDescriptionItsCurvesAndItsSpans) {
  const Effect effect = effect_of({drifting(2)});
  uint64_t tables[2];
  for (const uint32_t i : {0u, 1u}) {
    std::vector<Call> calls;
    for (uint32_t call = 0; call < 200 * (i + 1); ++call) calls.push_back(call_of(effect, call));
    Simulation simulation = simulate(calls);
    simulation.seek(0);
    simulation.step();
    tables[i] = table_bytes();
  }
  constexpr uint64_t kLists = 3, kBirthTable = 2 * sizeof(uint32_t);
  const double described = sizeof(shared::EmitterData) + sizeof(CurveTable);
  const double a_span = sizeof(shared::Span) + 1;  // and its share of the groups'
  EXPECT_LE(double(tables[1] - tables[0]) / 200, 1.5 * (described + kLists * a_span + kBirthTable) + 1);
  EXPECT_GE(double(tables[1] - tables[0]) / 200, described) << "what it has is counted";
}

}  // namespace
}  // namespace plume
