#include "sandbox/effects/instances.h"

#include <algorithm>

#include "sandbox/effects/card_kernels.h"
#include "sandbox/effects/influence.h"

namespace plume {
namespace {

SpawnSchedule schedule_of(const Call& call, const Lineage& lineage) {
  return SpawnSchedule(lineage.spawn, {.path = call.path ? &*call.path : nullptr,
                                       .stop_tick = call.stop_tick ? *call.stop_tick - call.tick : UINT32_MAX,
                                       .per_root = lineage.per_root,
                                       .life = lineage.life});
}

CallState call_state(Call call, uint32_t first_emitter) {
  Clock clock(call.tick);
  for (const Freeze& freeze : call.freezes) clock.freeze(freeze);
  CallState instance{
      .call = std::move(call), .clock = std::move(clock), .first_emitter = first_emitter, .demand = {}};
  instance.demand.name = instance.call.name;
  instance.demand.called = true;
  return instance;
}

}  // namespace

Instances make_instances(std::vector<Call> calls, uint32_t scene_seed, glm::vec3 wind,
                         const std::vector<Solid>& solids, glm::vec3 sun_direction, MotionTables& tables,
                         MeshTable& meshes) {
  struct Member {
    uint32_t call, index;
    uint32_t card_kernel;
  };
  Instances result;
  std::vector<Member> members;
  std::vector<std::vector<Bounds>> drawn;  // by call and emitter
  for (Call& call : calls) {
    drawn.push_back(emitter_bounds(*call.effect, {.position = call.position,
                                                  .yaw_deg = call.yaw_deg,
                                                  .path = call.path ? &*call.path : nullptr,
                                                  .wind = wind,
                                                  .solids = &solids}));
    const uint32_t first = uint32_t(members.size());
    for (uint32_t e = 0; e < call.effect->emitters.size(); ++e)
      members.push_back({uint32_t(result.calls.size()), e,
                         card_kernel(call.effect->emitters[e].look, features_of(call, e))});
    result.calls.push_back(call_state(std::move(call), first));
  }
  std::ranges::stable_sort(members, {}, &Member::card_kernel);

  result.emitter_of_call.resize(members.size());
  for (const auto& [call, index, kernel] : members) {
    CallState& instance = result.calls[call];
    const Lineage lineage = lineage_of(instance.described(), index);
    result.emitter_of_call[instance.first_emitter + index] = uint32_t(result.emitters.size());
    const Emitter& described = instance.described()[index];
    EmitterState& emitter = result.emitters.emplace_back(
        EmitterState{.call = call,
                     .index = index,
                     .card_kernel = kernel,
                     .features = features_of(instance.call, index),
                     .schedule = schedule_of(instance.call, lineage),
                     .lineage = lineage,
                     .data = emitter_data(instance.call, index, scene_seed, wind, meshes),
                     .curves = bake_curves(described.look),
                     .bounds = influence(described.look, drawn[call][index], sun_direction)});
    tables.fill(described, emitter.data, &drawn[call][index]);
    instance.last_tick = std::max(instance.last_tick, emitter.schedule.last_tick());
  }
  return result;
}

}  // namespace plume
