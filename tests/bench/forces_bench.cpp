// One tick of particles under each set of forces. A step reads and writes 32 bytes a particle: its floor is a
// copy of 64 bytes.
#include <functional>

#include "tests/bench/particle_cloud.h"

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

const std::vector<Solid> kSolids{
    {.kind = SolidKind::kPlane, .position = {0, -1, 0}, .size_m = {100, 0, 100}},
    {.kind = SolidKind::kBox, .position = {3, 0, 0}, .size_m = {1, 2, 1}},
    {.kind = SolidKind::kSphere, .position = {-3, 0, 0}, .radius_m = 1},
    {.kind = SolidKind::kCapsule, .position = {0, -1, 3}, .end = {0, 2, 3}, .radius_m = 0.1f}};

void step(benchmark::State& state, const Forces& forces) {
  Emitter emitter = cloud_of(uint32_t(state.range(0)), kLife);
  forces(emitter.motion);
  const Effect effect = effect_of(emitter);
  Simulation simulation = simulate(effect, 1, kSolids);
  simulation.seek(0);
  simulation.step();
  AgainstCopy result(state, "particles/s", double(state.range(0)), kStepBytes);
  for (auto _ : state) {
    if (simulation.tick() + 2 >= kLife) simulation.seek(1);  // all alive, always
    result.measure([&] { return seconds_of(simulation.step(), "simulate"); });
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  for (const int64_t particles : {10'000, 100'000, 1'000'000, 4'000'000}) benchmark->Arg(particles);
  timed(benchmark);
}

BENCHMARK_CAPTURE(step, no_more, no_more)->Apply(sizes);
BENCHMARK_CAPTURE(step, curl, curl)->Apply(sizes);
BENCHMARK_CAPTURE(step, vortex, vortex)->Apply(sizes);
BENCHMARK_CAPTURE(step, orbit, orbit)->Apply(sizes);
BENCHMARK_CAPTURE(step, attractors, attractors)->Apply(sizes);
BENCHMARK_CAPTURE(step, field, field)->Apply(sizes);
BENCHMARK_CAPTURE(step, kill, kill)->Apply(sizes);
BENCHMARK_CAPTURE(step, collisions, collisions)->Apply(sizes);
BENCHMARK_CAPTURE(step, everything, everything)->Apply(sizes);

}  // namespace
}  // namespace plume
