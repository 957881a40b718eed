// One emitter in an empty scene, or among solids, and where its particles are at a tick.
#ifndef PLUME_TESTS_MOVING_PARTICLES_H
#define PLUME_TESTS_MOVING_PARTICLES_H

#include <cmath>

#include "tests/gpu/gpu_test.h"

namespace plume {

constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

class MovingParticles : public GpuTest {
 protected:
  struct Place {
    glm::vec3 wind{0.0f};
    glm::vec3 origin{0.0f};
    float yaw_deg = 0.0f;
    std::vector<Solid> solids{};
  };

  /// So many particles born at tick 0 in the origin, which nothing moves.
  static Emitter emitter(uint32_t count = 64) {
    Emitter e;
    e.name = "test";
    e.spawn.bursts = {{0, count}};
    e.spawn.life_ticks = {10'000, 10'000};
    e.look.cross_section_m2 = 0.1f;
    return e;
  }
  static Effect effect_of(std::vector<Emitter> emitters) {
    return {.id = "test", .name = "", .description = "", .layers = {}, .emitters = std::move(emitters)};
  }
  /// `effect` outlives the simulation.
  Simulation simulate(const Effect& effect, const Place& place) {
    return Simulation(device, pipelines,
                      {{.name = "test",
                        .effect = &effect,
                        .tick = 0,
                        .position = place.origin,
                        .yaw_deg = place.yaw_deg,
                        .seed = 1}},
                      1, place.wind, place.solids);
  }
  std::vector<shared::Particle> particles_at(const Emitter& e, uint32_t tick, const Place& place) {
    const Effect effect = effect_of({e});
    Simulation simulation = simulate(effect, place);
    simulation.seek(tick);
    return simulation.particles();
  }
  std::vector<shared::Particle> particles_at(const Emitter& e, uint32_t tick) {
    return particles_at(e, tick, Place());
  }
  /// The states of its only particle at ticks 0 .. last, stepped.
  std::vector<shared::Particle> track(const Emitter& e, uint32_t last, const Place& place) {
    const Effect effect = effect_of({e});
    Simulation simulation = simulate(effect, place);
    simulation.seek(0);
    std::vector<shared::Particle> states{simulation.particles().at(0)};
    while (simulation.tick() < last) {
      simulation.step();
      states.push_back(simulation.particles().at(0));
    }
    return states;
  }

  static bool is_dead(const shared::Particle& p) { return (p.state & shared::kDeadAge) == shared::kDeadAge; }
  static uint32_t contact_of(const shared::Particle& p) {
    return (p.state >> shared::kContactShift) & ((1u << shared::kContactBits) - 1);
  }
  static uint32_t collisions_of(const shared::Particle& p) { return contact_of(p) / shared::kOneCollision; }
};

}  // namespace plume
#endif
