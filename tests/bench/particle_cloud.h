// The effects that the benchmarks of the simulation move: a cloud of particles in the air.
#ifndef PLUME_BENCH_PARTICLE_CLOUD_H
#define PLUME_BENCH_PARTICLE_CLOUD_H

#include "tests/bench/gpu_bench.h"

namespace plume {

/// Drifts, rises and slows down, for so many ticks. Nothing is born yet.
inline Emitter cloud(uint32_t life_ticks) {
  Emitter emitter;
  emitter.name = "cloud";
  emitter.spawn.life_ticks = {life_ticks, life_ticks};
  emitter.shape = {.kind = ShapeKind::kSphere, .radius_m = 2.0f};
  emitter.motion.speed = {0.5f, 2.0f};
  emitter.motion.drag = 0.8f;
  emitter.motion.gravity = 0.05f;
  emitter.motion.buoyancy = 0.5f;
  emitter.look.cross_section_m2 = 0.1f;
  return emitter;
}

/// All born at once.
inline Emitter cloud_of(uint32_t count, uint32_t life_ticks) {
  Emitter emitter = cloud(life_ticks);
  emitter.spawn.bursts = {{0, count}};
  return emitter;
}

inline Effect effect_of(Emitter emitter) {
  return {.id = "cloud", .name = "", .description = "", .emitters = {std::move(emitter)}};
}

/// `effect`, which outlives the simulation, called so many times at once.
inline Simulation simulate(const Effect& effect, uint32_t instances = 1,
                           const std::vector<Solid>& solids = {}) {
  BenchDevice& bench = bench_device();
  std::vector<Call> calls;
  for (uint32_t i = 0; i < instances; ++i)
    calls.push_back({.name = std::to_string(i),
                     .effect = &effect,
                     .tick = 0,
                     .position = {0, 1, 0},
                     .yaw_deg = 0,
                     .seed = i});
  return Simulation(bench.device, bench.pipelines, std::move(calls), 1, {0, 0, 0}, solids);
}

/// Makes a simulation's cards as a frame does.
class CardMaker {
 public:
  explicit CardMaker(const Simulation& simulation);
  /// Its passes.
  std::vector<gpu::PassTime> make(const Simulation& simulation);

 private:
  gpu::Buffer cards_, view_;
};

}  // namespace plume
#endif
