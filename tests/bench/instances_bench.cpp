// What it costs that the same particles belong to many instances: a tick and its cards, on the device and on
// the host, against one instance that has them all. The two take turns, so that a busy machine slows both.
#include <ctime>

#include "sandbox/measure/statistics.h"
#include "tests/bench/particle_cloud.h"

namespace plume {
namespace {

constexpr uint32_t kParticles = 200'000, kLife = 200;

/// Of the calling thread alone: what the device does for it is not counted, nor is waiting.
double host_seconds() {
  timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + double(now.tv_nsec) * 1e-9;
}

/// Some die and some are born at each tick, as many as keep the number.
Emitter stream(uint32_t count) {
  Emitter emitter = cloud(kLife);
  emitter.motion.curl = {.strength = 1.0f, .scale_m = 2.0f, .speed = 0.1f, .octaves = 1};
  emitter.spawn.rate = {{0, double(count) / kLife * kTicksPerSecond},
                        {1'000'000, double(count) / kLife * kTicksPerSecond}};
  return emitter;
}

struct Run {
  explicit Run(uint32_t instances)
      : effect(effect_of(stream(kParticles / instances))), simulation(simulate(effect, instances)) {
    simulation.go_to(kLife);
    cards.emplace(simulation);
    tick();
    step.clear(), card.clear(), host.clear();
  }
  void tick() {
    const double before = host_seconds();
    step.push_back(seconds_of(simulation.step(), "simulate"));
    host.push_back(host_seconds() - before);
    card.push_back(seconds_of(cards->make(simulation), "cards"));
  }
  Effect effect;
  Simulation simulation;
  std::optional<CardMaker> cards;
  std::vector<double> step, card, host;  // seconds
};

double median(const std::vector<double>& seconds) {
  return summarise(seconds).median;
}

/// Of a pair, run by run: what slows the machine for a while slows both.
double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> ratios;
  for (size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return median(ratios);
}

std::vector<double> sum(std::vector<double> a, const std::vector<double>& b) {
  for (size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

void BM_Instances(benchmark::State& state) {
  Run one(1), many(uint32_t(state.range(0)));
  for (auto _ : state) {
    one.tick(), many.tick();
    state.SetIterationTime(many.step.back() + many.card.back());
  }
  state.counters["step_ms"] = median(many.step) * 1e3;
  state.counters["cards_ms"] = median(many.card) * 1e3;
  state.counters["host_ms"] = median(many.host) * 1e3;
  state.counters["step_ratio"] = ratio(many.step, one.step);
  state.counters["cards_ratio"] = ratio(many.card, one.card);
  const auto all = [](const Run& run) { return sum(sum(run.step, run.card), run.host); };
  state.counters["ratio_to_one"] = ratio(all(many), all(one));
}

BENCHMARK(BM_Instances)->Arg(1)->Arg(10)->Arg(100)->Arg(1000)->Apply(timed)->Iterations(41);

}  // namespace
}  // namespace plume
