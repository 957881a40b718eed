// All particles of a scene on the GPU. A particle is a function of (seed, birth index, tick), so stepping
// tick by tick and seeking to a tick directly give the same bits: an emitter that nobody sees has no memory
// and no dispatch, and is brought to its tick when somebody looks. See shaders/effects/lineage.glsl.
#ifndef PLUME_EFFECTS_SIMULATION_H
#define PLUME_EFFECTS_SIMULATION_H

#include <optional>

#include "renderer/gpu/frame.h"
#include "renderer/transparents.h"
#include "sandbox/effects/clock.h"
#include "sandbox/effects/demand.h"
#include "sandbox/effects/dispatch_length.h"
#include "sandbox/effects/emitter_data.h"
#include "sandbox/effects/lineage.h"
#include "sandbox/effects/motion_tables.h"
#include "sandbox/effects/span_list.h"
#include "sandbox/effects/spawn_schedule.h"
#include "sandbox/effects/view_volume.h"

namespace plume {

/// All cameras that look at a tick; nothing: everything is seen.
using Views = std::optional<std::vector<ViewVolume>>;
inline const Views kEverything{};

class Simulation {
 public:
  /// `calls` point at effects that outlive the simulation. Particles collide with `solids`.
  Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls, uint32_t scene_seed,
             glm::vec3 wind, const std::vector<Solid>& solids = {},
             glm::vec3 sun_direction = {0.0f, 1.0f, 0.0f});

  /// Who looks at a tick that go_to() passes over: decides whether time passes there for effects that pause
  /// off screen. Nothing: whoever looks at the tick that is gone to.
  void watch_by(std::function<Views(uint32_t tick)> script) { script_ = std::move(script); }
  /// Makes `tick` the current one for what `views` see: each emitter takes the shorter road, the others
  /// sleep. Waits for the device. Returns the passes it took.
  std::vector<gpu::PassTime> go_to(uint32_t tick, const Views& views);
  /// Everything is seen.
  std::vector<gpu::PassTime> go_to(uint32_t tick) { return go_to(tick, kEverything); }
  /// The two roads by name. step() goes to the next tick; any tick must have been reached before.
  std::vector<gpu::PassTime> seek(uint32_t tick);
  std::vector<gpu::PassTime> step() { return go_to(tick() + 1); }
  /// Stops the time of a call after the present tick, by hand, or lets it go on.
  void set_frozen(uint32_t call, bool frozen);

  uint32_t tick() const { return tick_.value(); }
  /// Cards that record_cards() writes: of the living, the just dead and those not born yet.
  uint32_t cards() const;
  /// The same by source, in the order of the enumeration, which is also that of the cards.
  std::array<uint32_t, kSources> cards_by_source() const;
  /// The same by emitter, in the order of calls and of their emitters.
  struct EmitterCards {
    uint32_t first, count;
    uint32_t call;  ///< which of the calls
    const Emitter* emitter;
    glm::vec3 origin;  ///< of the emitter, world
    int draw_order;
  };
  std::vector<EmitterCards> cards_by_emitter() const;
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

  /// The states of all particles in the living windows, in the order of emitters and births. Waits for the
  /// device.
  std::vector<shared::Particle> particles() const;
  /// FNV-1a, 64 bits, of particles().
  uint64_t state_hash() const;
  /// One entry per call, in their order.
  std::vector<InstanceDemand> demand() const;

 private:
  struct EmitterState {
    uint32_t call;      // index into calls_
    uint32_t index;     // of the effect's emitters
    uint32_t cards;     // kernel that draws it, which begins with its source
    uint32_t features;  // kUses...
    SpawnSchedule schedule;
    Lineage lineage;
    shared::EmitterData data;
    CurveTable curves;
    Bounds bounds;  // of its influence

    std::optional<uint32_t> wanted = {};   // its own tick that is asked for; nothing: it sleeps
    std::optional<uint32_t> reached = {};  // that of its particles in the pool
    uint32_t base = 0;                     // its first slot there
    uint32_t place = 0;                    // in the table of emitters on the device
    uint32_t ticks = 0, dispatches = 0;    // that reaching it took
    uint32_t slots() const { return uint32_t(schedule.capacity()); }
  };
  struct CallState {
    Call call;
    Clock clock;
    uint32_t first_emitter;  // index into emitter_of_call_: the call's, in the order of its effect
    uint32_t last_tick = 0;  // its own, at which anything can be alive
    InstanceDemand demand;
  };

  const EmitterState& emitter_of(uint32_t call, uint32_t index) const {
    return emitters_[emitter_of_call_[calls_[call].first_emitter + index]];
  }
  void forget_after(CallState& call, uint32_t tick);
  void pass_time(uint32_t tick, const Views& views);
  bool is_seen(uint32_t call, const Views& views) const;
  bool has_living(const EmitterState& emitter, uint32_t tick) const;
  std::string why_asleep(const CallState& call, uint32_t tick) const;
  std::vector<vk::BufferCopy> lay_out_pool();
  void fill_tables();
  void plan();
  uint32_t living(const EmitterState& emitter) const;
  uint32_t cards_of(const EmitterState& emitter) const { return living(emitter) * emitter.data.cards_each; }
  shared::Span span_of(const EmitterState& emitter, uint64_t first, uint64_t end) const;
  void add_seek(const EmitterState& emitter, uint64_t first, uint64_t end);
  gpu::Bindings mesh_bindings() const;
  void record(gpu::Pass& pass, const char* shader, const SpanList& list) const;
  void count_demand(uint32_t tick, bool jumped);

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  std::vector<CallState> calls_;
  std::vector<EmitterState> emitters_;      // by kernel of cards: those of one source stand together
  std::vector<uint32_t> emitter_of_call_;   // by call and index, into emitters_
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
  std::function<Views(uint32_t tick)> script_;
};

}  // namespace plume
#endif
