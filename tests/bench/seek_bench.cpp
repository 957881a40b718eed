// Bringing particles to an age from their births: what waking an effect and jumping in time cost.
#include "tests/bench/particle_cloud.h"

namespace plume {
namespace {

/// items are particle ticks: a seek to age A integrates A ticks of every particle.
void BM_Seek(benchmark::State& state) {
  const uint32_t particles = uint32_t(state.range(0)), age = uint32_t(state.range(1));
  Emitter emitter = cloud_of(particles, kMaxLife);
  emitter.motion.curl = {.strength = 1.0f, .scale_m = 2.0f, .speed = 0.1f, .octaves = 1};
  const Effect effect = effect_of(emitter);
  Simulation simulation = simulate(effect);
  simulation.seek(age);
  const double particle_ticks = double(particles) * age;
  AgainstCopy result(state, "particle_ticks/s", particle_ticks, 2.0 * sizeof(shared::Particle) / age);
  for (auto _ : state) result.measure([&] { return seconds_of(simulation.seek(age), "simulate"); });
}

BENCHMARK(BM_Seek)->ArgsProduct({{1'000}, {100, 1'000, 10'000, kMaxLife - 1}})->Apply(timed)->Iterations(5);
BENCHMARK(BM_Seek)->ArgsProduct({{100'000}, {1, 10, 100, 600}})->Apply(timed);

}  // namespace
}  // namespace plume
