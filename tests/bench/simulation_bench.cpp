// The step kernel, the catch-up kernel and the making of cards, over numbers of particles. A step reads and
// writes 32 bytes a particle: its floor is a copy of 64 bytes.
#include <functional>

#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/bench/gpu_bench.h"

namespace plume {
namespace {

constexpr uint32_t kLife = 600;
constexpr double kStepBytes = 2 * sizeof(shared::Particle);

using Forces = std::function<void(Motion&)>;

void no_more(Motion&) {}
void curl(Motion& m) {
  m.curl = {.strength = 1.0f, .scale_m = 2.0f, .speed = 0.1f, .octaves = 1};
}
void vortex(Motion& m) {
  m.vortex = {.strength = 1.0f, .radius_m = 1.0f, .pull = 0.5f};
}
void orbit(Motion& m) {
  m.orbit = 0.1f;
}
void attractors(Motion& m) {
  m.attractors = {{.from_m = {2, 1, 0}, .to_m = {2, 1, 0}, .strength = 1.0f},
                  {.from_m = {-2, 0, 0}, .to_m = {-2, 2, 0}, .strength = -1.0f}};
}
void field(Motion& m) {
  FieldGrid grid{.size = {10, 10, 10}, .low = glm::vec3(-10), .high = glm::vec3(10), .cells = {}};
  for (uint32_t i = 0; i < 1000; ++i)
    grid.cells.push_back(glm::vec3(float(i % 7) - 3.0f, 0.5f, float(i % 5) - 2.0f));
  m.field = VectorField{.id = "bench", .grid = std::make_shared<FieldGrid>(std::move(grid)), .offset_m = {}};
}
void kill(Motion& m) {
  m.kill = {{.kind = KillVolume::Kind::kSphere, .radius_m = 500.0f, .outside = true}};
}
/// With the ground and one of each other solid.
void collisions(Motion& m) {
  m.gravity = 0.2f;
  m.collision = Collision{.bounce = 0.4f, .friction = 0.3f, .radius_m = 0.02f};
}
void everything(Motion& m) {
  for (const auto forces : {curl, vortex, orbit, attractors, field, kill, collisions}) forces(m);
}

/// So many particles born at once that live ten seconds, moved by everything the forces argument names.
Effect cloud(uint32_t count, const Forces& forces) {
  Emitter emitter;
  emitter.name = "cloud";
  emitter.spawn.bursts = {{0, count}};
  emitter.spawn.life_ticks = {kLife, kLife};
  emitter.shape = {.kind = ShapeKind::kSphere, .radius_m = 2.0f};
  emitter.motion.speed = {0.5f, 2.0f};
  emitter.motion.drag = 0.8f;
  emitter.motion.gravity = 0.05f;
  emitter.motion.buoyancy = 0.5f;
  forces(emitter.motion);
  emitter.look.cross_section_m2 = 0.1f;
  return {.id = "cloud", .name = "", .description = "", .emitters = {emitter}};
}

Simulation simulate(const Effect& effect) {
  BenchDevice& bench = bench_device();
  return Simulation(
      bench.device, bench.pipelines,
      {{.name = "cloud", .effect = &effect, .tick = 0, .position = {0, 1, 0}, .yaw_deg = 0, .seed = 1}}, 1,
      {0, 0, 0},
      {{.kind = SolidKind::kPlane, .position = {0, -1, 0}, .size_m = {100, 0, 100}},
       {.kind = SolidKind::kBox, .position = {3, 0, 0}, .size_m = {1, 2, 1}},
       {.kind = SolidKind::kSphere, .position = {-3, 0, 0}, .radius_m = 1},
       {.kind = SolidKind::kCapsule, .position = {0, -1, 3}, .end = {0, 2, 3}, .radius_m = 0.1f}});
}

void step(benchmark::State& state, const Forces& forces) {
  const Effect effect = cloud(uint32_t(state.range(0)), forces);
  Simulation simulation = simulate(effect);
  simulation.seek(0);
  simulation.step();
  AgainstCopy result(state, "particles/s", double(state.range(0)), kStepBytes);
  for (auto _ : state) {
    if (simulation.tick() + 2 >= kLife) simulation.seek(1);  // all alive, always
    result.add(seconds_of(simulation.step(), "simulate"));
  }
}

void BM_StepWithoutNoise(benchmark::State& state) {
  step(state, no_more);
}
void BM_StepWithCurlNoise(benchmark::State& state) {
  step(state, curl);
}

/// items are particle ticks: a seek to age A integrates A ticks of every particle.
void BM_SeekWithCurlNoise(benchmark::State& state) {
  const Effect effect = cloud(uint32_t(state.range(0)), curl);
  const uint32_t age = uint32_t(state.range(1));
  Simulation simulation = simulate(effect);
  simulation.seek(age);
  AgainstCopy result(state, "particle_ticks/s", double(state.range(0)) * age, kStepBytes / age);
  for (auto _ : state) result.add(seconds_of(simulation.seek(age), "simulate"));
}

void BM_Cards(benchmark::State& state) {
  BenchDevice& bench = bench_device();
  const Effect effect = cloud(uint32_t(state.range(0)), no_more);
  Simulation simulation = simulate(effect);
  simulation.seek(30);
  const gpu::Buffer cards(
      bench.device,
      {.owner = "bench", .label = "cards", .bytes = uint64_t(state.range(0)) * sizeof(shared::Card)});
  Scene scene;
  scene.camera = {CameraKey{}};
  const gpu::Buffer view = gpu::make_buffer(bench.device, "bench", "view",
                                            std::vector{make_view(scene, scene.camera[0], {640, 360}, 30)});
  AgainstCopy result(state, "particles/s", double(state.range(0)),
                     sizeof(shared::Particle) + sizeof(shared::Card));
  for (auto _ : state) {
    gpu::Frame frame(bench.device, bench.pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    result.add(seconds_of(frame.finish(), "cards"));
  }
}

BENCHMARK(BM_StepWithoutNoise)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Apply(timed);
BENCHMARK(BM_StepWithCurlNoise)->Arg(10'000)->Arg(100'000)->Arg(1'000'000)->Apply(timed);
BENCHMARK_CAPTURE(step, vortex, vortex)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, orbit, orbit)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, attractors, attractors)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, field, field)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, kill, kill)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, collisions, collisions)->Arg(100'000)->Apply(timed);
BENCHMARK_CAPTURE(step, everything, everything)->Arg(100'000)->Apply(timed);
BENCHMARK(BM_SeekWithCurlNoise)
    ->Args({100'000, 10})
    ->Args({100'000, 100})
    ->Args({100'000, 590})
    ->Apply(timed);
BENCHMARK(BM_Cards)->Arg(100'000)->Arg(1'000'000)->Apply(timed);

}  // namespace
}  // namespace plume
