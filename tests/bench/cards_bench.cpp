// Particles to cards: 32 bytes are read and 96 written for each.
#include "shaders/shared/card.h"
#include "tests/bench/particle_cloud.h"

namespace plume {
namespace {

void BM_Cards(benchmark::State& state) {
  const Effect effect = effect_of(cloud_of(uint32_t(state.range(0)), 600));
  Simulation simulation = simulate(effect);
  simulation.seek(30);
  CardMaker cards(simulation);
  AgainstCopy result(state, "particles/s", double(state.range(0)),
                     sizeof(shared::Particle) + sizeof(shared::Card));
  for (auto _ : state) result.measure([&] { return seconds_of(cards.make(simulation), "cards"); });
}

BENCHMARK(BM_Cards)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Apply(timed);

}  // namespace
}  // namespace plume
