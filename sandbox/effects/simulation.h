// All particles of a scene on the GPU. A particle is a function of (seed, birth index, tick), so stepping
// tick by tick and seeking to a tick directly give the same bits; what is asleep has no memory and no
// dispatch.
#ifndef PLUME_EFFECTS_SIMULATION_H
#define PLUME_EFFECTS_SIMULATION_H

#include <optional>

#include "renderer/gpu/frame.h"
#include "renderer/transparents.h"
#include "sandbox/effects/demand.h"
#include "sandbox/effects/emitter_data.h"
#include "sandbox/effects/spawn_schedule.h"

namespace plume {

class Simulation {
 public:
  /// `calls` point at effects that outlive the simulation.
  Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls, uint32_t scene_seed,
             glm::vec3 wind);

  /// Makes `tick` the current one by the shorter of the two roads. Waits for the device. Returns the passes
  /// it took.
  std::vector<gpu::PassTime> go_to(uint32_t tick);
  /// The two roads by name. step() goes to the next tick; any tick must have been reached before.
  std::vector<gpu::PassTime> seek(uint32_t tick);
  std::vector<gpu::PassTime> step();

  uint32_t tick() const { return tick_.value(); }
  /// Cards that record_cards() writes: the living and the just dead.
  uint32_t cards() const { return living_.threads; }
  /// The same by source, in the order of the enumeration, which is also that of the cards.
  std::array<uint32_t, kSources> cards_by_source() const;
  /// The same by emitter, in the order of calls and of their emitters.
  struct EmitterCards {
    uint32_t first, count;
    glm::vec3 origin;  ///< of the emitter, world
    int draw_order;
  };
  std::vector<EmitterCards> cards_by_emitter() const;
  void record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards,
                    uint32_t first_card) const;

  /// The states of all particles in the living windows, in the order of emitters and births. Waits for the
  /// device.
  std::vector<shared::Particle> particles() const;
  /// FNV-1a, 64 bits, of particles().
  uint64_t state_hash() const;
  /// One entry per call, in their order.
  std::vector<InstanceDemand> demand() const;

 private:
  struct EmitterState {
    uint32_t call;   // index into calls_
    uint32_t index;  // of the effect's emitters
    glm::vec3 origin;
    Source source;
    SpawnSchedule schedule;
    uint32_t max_life;
    bool awake = false;
  };
  struct CallState {
    Call call;
    uint32_t last_tick = 0;  // of the scene, at which anything can be alive
    InstanceDemand demand;
  };

  uint32_t local_tick(const EmitterState& emitter, uint32_t tick) const {
    return tick - calls_[emitter.call].call.tick;
  }
  bool has_living(const EmitterState& emitter, uint32_t tick) const;
  bool wake_and_sleep(uint32_t tick);
  struct SpanList {
    std::vector<shared::Span> spans;
    gpu::Buffer buffer;
    uint32_t threads = 0;
  };
  /// One span per awake emitter of the births that `window` gives for it, empty ones left out.
  void make_spans(SpanList& list,
                  const std::function<std::pair<uint64_t, uint64_t>(const EmitterState&)>& window);
  void make_birth_table(SpanList& list, uint32_t tick);
  void record(gpu::Pass& pass, const char* shader, const SpanList& list, uint32_t tick) const;
  void count_demand(uint32_t tick, bool seeking);

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  std::vector<CallState> calls_;
  std::vector<EmitterState> emitters_;
  gpu::Buffer emitter_data_, curves_;
  gpu::Buffer particles_, births_;
  SpanList living_;  // every particle that can be alive at this tick: what cards are made of
  SpanList moving_;  // those that were there before this tick
  SpanList fresh_;   // those born at this tick
  std::optional<uint32_t> tick_;
};

}  // namespace plume
#endif
