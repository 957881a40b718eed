// The effects that a scene calls, and all that is known of their emitters before a particle moves. What is
// wanted of each at a tick, and where its particles are in the pool, is noted here by those who decide it:
// effects/wakefulness.h and effects/simulation.h.
#ifndef PLUME_EFFECTS_INSTANCES_H
#define PLUME_EFFECTS_INSTANCES_H

#include <optional>
#include <vector>

#include "sandbox/effects/clock.h"
#include "sandbox/effects/demand.h"
#include "sandbox/effects/emitter_data.h"
#include "sandbox/effects/lineage.h"
#include "sandbox/effects/motion_tables.h"
#include "sandbox/effects/spawn_schedule.h"

namespace plume {

/// One emitter of one instance.
struct EmitterState {
  uint32_t call;         // index of the instance
  uint32_t index;        // of the effect's emitters
  uint32_t card_kernel;  // see effects/card_kernels.h
  uint32_t features;     // kUses...
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

  bool is_analytic() const { return (features & shared::kIsAnalytic) != 0; }
  /// Of the pool.
  uint32_t slots() const { return is_analytic() ? 0 : uint32_t(schedule.capacity()); }
  /// Births that may be alive at its own tick are [first_alive, births).
  bool has_living(uint32_t tick) const { return schedule.births(tick) > schedule.first_alive(tick); }
  /// How many may be at the tick that is wanted.
  uint32_t living() const { return uint32_t(schedule.births(*wanted) - schedule.first_alive(*wanted)); }
  uint32_t cards() const { return living() * data.cards_each; }
};

/// One effect that is called.
struct CallState {
  Call call;
  Clock clock;
  uint32_t first_emitter;  // index into Instances::emitter_of_call
  uint32_t last_tick = 0;  // its own, at which anything can be alive
  InstanceDemand demand;

  const std::vector<Emitter>& described() const { return call.effect->emitters; }
};

struct Instances {
  std::vector<CallState> calls;
  std::vector<EmitterState> emitters;     // by kernel of cards: those of one source stand together
  std::vector<uint32_t> emitter_of_call;  // by call and index, into emitters

  const EmitterState& emitter_of(uint32_t call, uint32_t index) const {
    return emitters[emitter_of_call[calls[call].first_emitter + index]];
  }
  const Emitter& described(const EmitterState& emitter) const {
    return calls[emitter.call].described()[emitter.index];
  }
};

/// `calls` point at effects that outlive the instances. Enters into the tables what their emitters need.
Instances make_instances(std::vector<Call> calls, uint32_t scene_seed, glm::vec3 wind,
                         const std::vector<Solid>& solids, glm::vec3 sun_direction, MotionTables& tables,
                         MeshTable& meshes);

}  // namespace plume
#endif
