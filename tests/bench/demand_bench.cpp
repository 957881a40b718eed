// What effects cost that a scene declares and does not call: a tick and a picture of a scene that declares
// 100 and calls 2, against one that declares those 2. The two take turns, so that a busy machine slows both.
// That they take the same memory, passes and pipelines is a test: tests/gpu/demand_test.cpp.
#include "sandbox/measure/statistics.h"
#include "tests/bench/gpu_bench.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{320, 180};
constexpr uint32_t kFirstTick = 40, kLastTick = 70;  // both effects are in full swing

Scene declaring(uint32_t effects) {
  Scene scene;
  scene.camera = {CameraKey{}};
  const auto ids = bench_device().library.ids(PresetKind::kEffect);
  for (uint32_t i = 0; i < effects; ++i)
    scene.instances.push_back({.name = std::to_string(i), .effect = ids[i % ids.size()], .effect_at = {}});
  scene.instances[0].effect = "smoke_grenade", scene.instances[1].effect = "fireball";
  scene.instances[0].call_tick = scene.instances[1].call_tick = 0;
  return scene;
}

struct Run {
  explicit Run(uint32_t effects)
      : stage(bench_device().device, bench_device().pipelines, bench_device().library, declaring(effects)) {}
  /// Seconds of all passes of the next tick.
  double tick() {
    now = now < kLastTick ? now + 1 : kFirstTick;
    double ms = 0;
    for (const gpu::PassTime& pass : stage.go_to(now, kSize)) ms += pass.ms;
    for (const gpu::PassTime& pass : render_frame(bench_device().device, bench_device().pipelines, targets,
                                                  stage.prelude(), stage.transparents(), method)
                                         .passes)
      ms += pass.ms;
    return ms * 1e-3;
  }
  Stage stage;
  Targets targets{bench_device().device, kSize};
  MethodInstance method{.method = make_method("avboit"), .owner = "avboit", .resources = {}};
  uint32_t now = kFirstTick - 1;
};

struct Cost {
  double seconds, cpu_seconds;
};

Cost cost_of_tick(Run& run) {
  const double before = cpu_seconds(), seconds = run.tick();
  return {seconds, cpu_seconds() - before};
}

void BM_DeclaredEffects(benchmark::State& state) {
  Run called(2), declared(uint32_t(state.range(0)));
  called.tick(), declared.tick();
  std::vector<double> seconds, ratios, cpu_ratios;
  for (auto _ : state) {
    const bool called_first = seconds.size() % 2;  // being second has its own price
    Cost alone{};
    if (called_first) alone = cost_of_tick(called);
    const Cost cost = cost_of_tick(declared);
    if (!called_first) alone = cost_of_tick(called);
    state.SetIterationTime(cost.seconds);
    seconds.push_back(cost.seconds);
    ratios.push_back(cost.seconds / alone.seconds);
    cpu_ratios.push_back(cost.cpu_seconds / alone.cpu_seconds);
  }
  state.counters["device_ms"] = summarise(seconds).median * 1e3;
  state.counters["ratio_to_called"] = summarise(ratios).median;
  state.counters["cpu_ratio_to_called"] = summarise(cpu_ratios).median;
}

BENCHMARK(BM_DeclaredEffects)->Arg(2)->Arg(100)->Apply(timed)->Iterations(61);

}  // namespace
}  // namespace plume
