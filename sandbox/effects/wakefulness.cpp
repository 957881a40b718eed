#include "sandbox/effects/wakefulness.h"

#include <fmt/format.h>

#include <algorithm>

namespace plume {
namespace {

bool sees(const Views& views, const Bounds& bounds) {
  return !views ||
         std::ranges::any_of(*views, [&](const ViewVolume& view) { return may_touch(view, bounds); });
}

bool is_seen(const Instances& instances, uint32_t call, const Views& views) {
  for (uint32_t e = 0; e < instances.calls[call].described().size(); ++e)
    if (sees(views, instances.emitter_of(call, e).bounds)) return true;
  return false;
}

std::string why_asleep(const Instances& instances, uint32_t call, uint32_t tick) {
  const CallState& instance = instances.calls[call];
  const std::optional<uint32_t> local = instance.clock.local(tick);
  if (!local) return fmt::format("starts at tick {}", instance.call.tick);
  if (*local > instance.last_tick) return fmt::format("finished at its tick {}", instance.last_tick);
  bool living = false;
  for (uint32_t e = 0; e < instance.described().size(); ++e)
    living |= instances.emitter_of(call, e).has_living(*local);
  if (!living) return "between births";
  return instance.clock.stood_still(tick) ? fmt::format("out of view, stopped at its tick {}", *local)
                                          : "out of view";
}

/// Pauses from a tick on. What the scene says of the time to come stays.
void forget_from(CallState& instance, uint32_t tick) {
  instance.clock.forget_from(tick);
  for (const Freeze& freeze : instance.call.freezes) instance.clock.freeze(freeze);
}

}  // namespace

void pass_time(Instances& instances, std::optional<uint32_t> before, uint32_t tick, const Views& views,
               const Script& script) {
  for (uint32_t i = 0; i < instances.calls.size(); ++i) {
    CallState& instance = instances.calls[i];
    if (instance.call.effect->off_screen != OffScreen::kPause) continue;
    if (before && *before > tick) forget_from(instance, tick + 1);
    const uint32_t first = std::max(before.value_or(0), instance.call.tick) + 1;
    if (first > tick) continue;
    const auto unless_seen = [&](uint32_t from, uint32_t end, const Views& by) {
      if (from < end && !is_seen(instances, i, by)) instance.clock.stand_still(from, end);
    };
    if (!script.views) {
      unless_seen(first, tick + 1, views);
      continue;
    }
    const uint32_t still = std::clamp(script.still_from, first, tick);
    for (uint32_t t = first; t < still; ++t) unless_seen(t, t + 1, script.views(t));
    unless_seen(still, tick, script.views(still));
    unless_seen(tick, tick + 1, views);
  }
}

void forget(Instances& instances) {
  for (CallState& instance : instances.calls) {
    forget_from(instance, 0);
    instance.demand.dispatches = instance.demand.ticks_simulated = instance.demand.ticks_saved = 0;
  }
  for (EmitterState& emitter : instances.emitters) emitter.reached.reset();
}

bool decide(Instances& instances, uint32_t tick, const Views& views) {
  bool moved = false;
  for (EmitterState& emitter : instances.emitters) {
    const std::optional<uint32_t> local = instances.calls[emitter.call].clock.local(tick);
    const bool seen = sees(views, emitter.bounds);
    emitter.wanted = local && seen && emitter.has_living(*local) ? local : std::nullopt;
    moved |= emitter.wanted.has_value() != emitter.reached.has_value();
  }
  return moved;
}

void count_demand(Instances& instances, uint32_t tick, bool jumped) {
  struct Count {
    uint64_t living = 0, ticks = 0, ticks_saved = 0, dispatches = 0;
    bool resident = false;
  };
  std::vector<Count> counts(instances.calls.size());
  for (CallState& instance : instances.calls) instance.demand.bytes = instance.demand.bytes_saved = 0;
  for (const EmitterState& emitter : instances.emitters) {
    CallState& instance = instances.calls[emitter.call];
    InstanceDemand& demand = instance.demand;
    Count& count = counts[emitter.call];
    const uint64_t bytes = uint64_t(emitter.slots()) * sizeof(shared::Particle);
    if (emitter.wanted) {
      demand.bytes += bytes;
      count.resident = true;
      count.living += emitter.living();
      count.ticks = std::max<uint64_t>(count.ticks, emitter.ticks);
      count.dispatches = std::max<uint64_t>(count.dispatches, emitter.dispatches);
    } else if (const auto local = instance.clock.local(tick); local && emitter.has_living(*local)) {
      demand.bytes_saved += bytes;
      const uint32_t ticks = jumped ? std::min(*local, emitter.lineage.life) : 1;
      count.ticks_saved = std::max<uint64_t>(count.ticks_saved, emitter.is_analytic() ? 0 : ticks);
    }
  }
  for (size_t i = 0; i < instances.calls.size(); ++i) {
    CallState& instance = instances.calls[i];
    InstanceDemand& demand = instance.demand;
    const Count& count = counts[i];
    demand.dispatches += count.dispatches;
    demand.ticks_simulated += count.ticks;
    demand.ticks_saved += count.ticks_saved;
    const bool frozen = count.resident && count.ticks == 0 && instance.clock.stood_still(tick);
    demand.awake = count.resident && !frozen;
    demand.why = frozen           ? fmt::format("frozen at its tick {}", *instance.clock.local(tick))
                 : count.resident ? fmt::format("has {} particles", count.living)
                                  : why_asleep(instances, uint32_t(i), tick);
  }
}

}  // namespace plume
