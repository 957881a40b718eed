// All particles of a scene on the GPU. A particle is a function of (seed, birth index, tick), so stepping
// tick by tick and seeking to a tick directly give the same bits: an emitter that nobody sees has no memory
// and no dispatch, and is brought to its tick when somebody looks. See shaders/effects/lineage.glsl.
#ifndef PLUME_EFFECTS_SIMULATION_H
#define PLUME_EFFECTS_SIMULATION_H

#include <map>
#include <optional>

#include "renderer/gpu/frame.h"
#include "sandbox/effects/card_kernels.h"
#include "sandbox/effects/dispatch_length.h"
#include "sandbox/effects/instances.h"
#include "sandbox/effects/span_list.h"
#include "sandbox/effects/wakefulness.h"

namespace plume {

class Simulation {
 public:
  /// `calls` point at effects that outlive the simulation. Particles collide with `solids`.
  Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls, uint32_t scene_seed,
             glm::vec3 wind, const std::vector<Solid>& solids = {},
             glm::vec3 sun_direction = {0.0f, 1.0f, 0.0f});

  /// Who looks at a tick that go_to() passes over: decides whether time passes there for effects that pause
  /// off screen. Nothing: whoever looks at the tick that is gone to.
  void watch_by(Script script) { script_ = std::move(script); }
  /// Makes `tick` the current one for what `views` see: each emitter takes the shorter road, the others
  /// sleep. Waits for the device. Returns the passes it took.
  std::vector<gpu::PassTime> go_to(uint32_t tick, const Views& views);
  /// Everything is seen.
  std::vector<gpu::PassTime> go_to(uint32_t tick) { return go_to(tick, kEverything); }
  /// The two roads by name. step() goes to the next tick; any tick must have been reached before.
  std::vector<gpu::PassTime> seek(uint32_t tick);
  std::vector<gpu::PassTime> step() { return go_to(tick() + 1); }
  /// Before the first tick: takes over the particles of emitters that `old` simulates too, with the same
  /// states, so that those are not brought from their births. `was` says for each call which one it is
  /// there; nothing: it is new. The effects that `old` points at must be there still; it is of no use any
  /// more.
  void adopt(Simulation& old, const std::vector<std::optional<uint32_t>>& was);

  /// Forgets all ticks and what they took: the next go_to() is as that of a simulation just made.
  void start_over();

  uint32_t tick() const { return tick_.value(); }
  /// Cards that record_cards() writes: of the living, the just dead and those not born yet.
  uint32_t cards() const;
  /// Which of them are whose: see effects/card_kernels.h.
  const Instances& instances() const { return instances_; }
  /// `bodies`, when light asks for them: shared::LitBody[cards()], one a card.
  void record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards, uint32_t first_card,
                    const gpu::Buffer* bodies = nullptr) const;

  /// What is opaque and drawn as meshes, the just dead and those not born yet included. Nothing: no buffers
  /// either.
  struct Pieces {
    struct Draw {
      shared::Span span;
      uint32_t triangles;  ///< of the largest mesh
    };
    std::vector<Draw> draws;  ///< one an emitter
    const gpu::Buffer *particles = nullptr, *emitters = nullptr, *curves = nullptr, *mesh_ranges = nullptr,
                      *mesh_triangles = nullptr;
  };
  Pieces pieces() const;

  /// The states of all particles in the living windows, in the order of emitters and births; of analytic
  /// emitters there are none. Waits for the device.
  std::vector<shared::Particle> particles() const;
  /// For tests: shared::Particle[], where birth k of an emitter is at its base + k mod slots.
  const gpu::Buffer& pool() const { return particles_; }
  /// FNV-1a, 64 bits, of particles().
  uint64_t state_hash() const;
  /// One entry per call, in their order.
  std::vector<InstanceDemand> demand() const;

 private:
  void count_loops(const EmitterState& emitter);
  std::vector<vk::BufferCopy> lay_out_pool();
  void fill_tables();
  void plan();
  shared::Span span_of(const EmitterState& emitter, uint64_t first, uint64_t end) const;
  void add_births(shared::Span& span, const EmitterState& emitter);
  void add_seek(const EmitterState& emitter, uint64_t first, uint64_t end);
  gpu::Bindings bindings(const SpanList& list) const;
  void record(gpu::Pass& pass, const char* shader, const SpanList& list) const;

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  Instances instances_;
  std::map<uint32_t, LoopsPerTick> loops_;  // by kernel that moves particles
  MotionTables tables_;
  MeshTable meshes_;
  gpu::Buffer emitter_data_, curves_, path_keys_;  // of those awake
  gpu::Buffer particles_, births_buffer_;
  std::vector<uint32_t> births_;      // how many were born before each tick: see Span
  SpanList living_;                   // every particle that can be alive at this tick: what cards are made of
  std::vector<Pieces::Draw> pieces_;  // the same of what is opaque
  SpanList steps_;                    // those that go on from the tick before
  std::vector<SpanList>
      seeks_;  // those that are brought to this tick from their births, dispatch by dispatch
  std::optional<uint32_t> tick_;
  Script script_;
};

}  // namespace plume
#endif
