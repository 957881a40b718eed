#include "sandbox/effects/simulation.h"

#include <fmt/format.h>

#include <algorithm>

namespace plume {
namespace {

using shared::Particle;
using shared::Span;

struct SimulationPush {
  uint32_t threads, span_count, tick;
};

struct CardsPush {
  uint32_t threads, span_count, first_card;
};

constexpr uint32_t kGroupSize = 64;

/// A host-visible buffer that holds `data`, made anew only when it has outgrown the old one.
template <class T>
void upload(gpu::Device& device, gpu::Buffer& buffer, const char* label, const std::vector<T>& data) {
  const uint64_t bytes = std::max<uint64_t>(data.size() * sizeof(T), 16);
  if (buffer.bytes() < bytes)
    buffer = gpu::Buffer(
        device, {.owner = "simulation", .label = label, .bytes = bytes + bytes / 2, .host_visible = true});
  std::copy(data.begin(), data.end(), buffer.mapped<T>().begin());
}

Source source_of(const Look& look) {
  return look.distortion_deg > 0.0f ? Source::kHaze : plume::source_of(look.transmission);
}

}  // namespace

Simulation::Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls,
                       uint32_t scene_seed, glm::vec3 wind)
    : device_(device), pipelines_(pipelines) {
  struct Member {
    uint32_t call, index;
    Source source;
  };
  std::vector<Member> members;
  for (Call& call : calls) {
    for (uint32_t e = 0; e < call.effect->emitters.size(); ++e)
      members.push_back({uint32_t(calls_.size()), e, source_of(call.effect->emitters[e].look)});
    calls_.push_back({.call = std::move(call), .last_tick = 0, .demand = {}});
    calls_.back().demand.name = calls_.back().call.name;
    calls_.back().demand.called = true;
  }
  std::ranges::stable_sort(members, {}, &Member::source);  // cards of one source stand together

  std::vector<shared::EmitterData> data;
  std::vector<glm::vec4> curves;
  for (const auto& [call, index, source] : members) {
    CallState& state = calls_[call];
    const Emitter& emitter = state.call.effect->emitters[index];
    data.push_back(emitter_data(state.call, index, scene_seed, wind));
    const CurveTable table = bake_curves(emitter.look);
    curves.insert(curves.end(), table.begin(), table.end());
    emitters_.push_back({.call = call,
                         .index = index,
                         .origin = data.back().origin,
                         .source = source,
                         .schedule = SpawnSchedule(emitter.spawn),
                         .max_life = emitter.spawn.life_ticks.max});
    state.last_tick = std::max(state.last_tick, state.call.tick + emitters_.back().schedule.last_tick());
  }
  if (emitters_.empty()) return;
  emitter_data_ = gpu::make_buffer(device, "simulation", "emitters", data);
  curves_ = gpu::make_buffer(device, "simulation", "curves", curves);
}

bool Simulation::has_living(const EmitterState& emitter, uint32_t tick) const {
  if (tick < calls_[emitter.call].call.tick) return false;
  const uint32_t local = local_tick(emitter, tick);
  return emitter.schedule.births(local) > emitter.schedule.first_alive(local);
}

bool Simulation::wake_and_sleep(uint32_t tick) {
  bool changed = false;
  uint64_t slots = 0;
  for (EmitterState& emitter : emitters_) {
    const bool awake = has_living(emitter, tick);
    changed |= awake != emitter.awake;
    emitter.awake = awake;
    if (awake) slots += emitter.schedule.capacity();
  }
  if (!changed) return false;
  particles_ = gpu::Buffer();  // the old pool goes before the new one comes
  if (slots > 0)
    particles_ = gpu::Buffer(
        device_, {.owner = "simulation", .label = "particles", .bytes = slots * sizeof(Particle)});
  return true;
}

void Simulation::make_spans(SpanList& list,
                            const std::function<std::pair<uint64_t, uint64_t>(const EmitterState&)>& window) {
  list.spans.clear();
  list.threads = 0;
  uint32_t base = 0;
  for (uint32_t i = 0; i < emitters_.size(); ++i) {
    const EmitterState& emitter = emitters_[i];
    if (!emitter.awake) continue;
    const uint32_t capacity = uint32_t(emitter.schedule.capacity());
    const auto [first, end] = window(emitter);
    if (end > first) {
      list.spans.push_back({.emitter = i,
                            .first = uint32_t(first),
                            .count = uint32_t(end - first),
                            .base = base,
                            .capacity = capacity,
                            .first_slot = uint32_t(first % capacity),
                            .offset = list.threads});
      list.threads += list.spans.back().count;
    }
    base += capacity;
  }
}

void Simulation::make_birth_table(SpanList& list, uint32_t tick) {
  std::vector<uint32_t> births;
  for (Span& span : list.spans) {
    const EmitterState& emitter = emitters_[span.emitter];
    const uint32_t local = local_tick(emitter, tick);
    span.births_base = uint32_t(births.size());
    span.births_tick = emitter.schedule.birth_tick(span.first);
    for (uint32_t t = span.births_tick; t <= local; ++t)
      births.push_back(uint32_t(emitter.schedule.births(t)));
    span.births_count = uint32_t(births.size()) - span.births_base;
  }
  upload(device_, births_, "births", births);
}

void Simulation::record(gpu::Pass& pass, const char* shader, const SpanList& list, uint32_t tick) const {
  if (list.threads == 0) return;
  pass.dispatch(
      pipelines_.compute(shader),
      {{"Particles", &particles_},
       {"Spans", &list.buffer},
       {"Emitters", &emitter_data_},
       {"Births", &births_}},
      SimulationPush{.threads = list.threads, .span_count = uint32_t(list.spans.size()), .tick = tick},
      {gpu::groups(list.threads, kGroupSize), 1, 1});
}

std::vector<gpu::PassTime> Simulation::seek(uint32_t tick) {
  wake_and_sleep(tick);
  make_spans(living_, [&](const EmitterState& emitter) {
    const uint32_t local = local_tick(emitter, tick);
    return std::pair(emitter.schedule.first_alive(local), emitter.schedule.births(local));
  });
  make_birth_table(living_, tick);
  upload(device_, living_.buffer, "living", living_.spans);
  tick_ = tick;
  count_demand(tick, true);
  if (living_.threads == 0) return {};
  gpu::Frame frame(device_, pipelines_);
  frame.pass("seek", [&](gpu::Pass& pass) { record(pass, "effects/seek.comp", living_, tick); });
  return frame.finish();
}

std::vector<gpu::PassTime> Simulation::step() {
  const uint32_t tick = tick_.value() + 1;
  // The pool is laid out for what is awake: when that changes, everybody is brought to the new tick directly.
  if (wake_and_sleep(tick)) return seek(tick);
  const auto born_before = [&](const EmitterState& emitter) {
    const uint32_t local = local_tick(emitter, tick);
    return local > 0 ? emitter.schedule.births(local - 1) : 0;
  };
  const auto alive_from = [&](const EmitterState& emitter) {
    return emitter.schedule.first_alive(local_tick(emitter, tick));
  };
  const auto born_until = [&](const EmitterState& emitter) {
    return emitter.schedule.births(local_tick(emitter, tick));
  };
  make_spans(living_, [&](const EmitterState& e) { return std::pair(alive_from(e), born_until(e)); });
  make_spans(moving_, [&](const EmitterState& e) { return std::pair(alive_from(e), born_before(e)); });
  make_spans(fresh_, [&](const EmitterState& e) { return std::pair(born_before(e), born_until(e)); });
  make_birth_table(fresh_, tick);
  upload(device_, living_.buffer, "living", living_.spans);
  upload(device_, moving_.buffer, "moving", moving_.spans);
  upload(device_, fresh_.buffer, "fresh", fresh_.spans);
  tick_ = tick;
  count_demand(tick, false);
  if (living_.threads == 0) return {};
  gpu::Frame frame(device_, pipelines_);
  frame.pass("step", [&](gpu::Pass& pass) {  // both at once: they touch different slots
    record(pass, "effects/tick.comp", moving_, tick);
    record(pass, "effects/seek.comp", fresh_, tick);
  });
  return frame.finish();
}

std::vector<gpu::PassTime> Simulation::go_to(uint32_t tick) {
  if (tick_ == tick) return {};
  if (tick_ && tick == *tick_ + 1) return step();
  return seek(tick);
}

void Simulation::record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards,
                              uint32_t first_card) const {
  if (living_.threads == 0) return;
  pass.dispatch(
      pipelines_.compute("effects/cards.comp"),
      {{"Particles", &particles_},
       {"Spans", &living_.buffer},
       {"Emitters", &emitter_data_},
       {"View", &view},
       {"Curves", &curves_},
       {"Cards", &cards}},
      CardsPush{
          .threads = living_.threads, .span_count = uint32_t(living_.spans.size()), .first_card = first_card},
      {gpu::groups(living_.threads, kGroupSize), 1, 1});
}

std::array<uint32_t, kSources> Simulation::cards_by_source() const {
  std::array<uint32_t, kSources> result{};
  for (const Span& span : living_.spans) result[size_t(emitters_[span.emitter].source)] += span.count;
  return result;
}

std::vector<Simulation::EmitterCards> Simulation::cards_by_emitter() const {
  std::vector<Span> spans = living_.spans;  // by source; the scene's order is that of calls
  std::ranges::sort(spans, {}, [&](const Span& span) {
    return std::pair(emitters_[span.emitter].call, emitters_[span.emitter].index);
  });
  std::vector<EmitterCards> result;
  for (const Span& span : spans) {
    const EmitterState& emitter = emitters_[span.emitter];
    const Call& call = calls_[emitter.call].call;
    result.push_back({.first = span.offset,
                      .count = span.count,
                      .origin = emitter.origin,
                      .draw_order = call.draw_order + call.effect->emitters[emitter.index].look.draw_order});
  }
  return result;
}

std::vector<Particle> Simulation::particles() const {
  std::vector<Particle> result;
  if (living_.threads == 0) return result;
  const auto pool = gpu::read<Particle>(device_, particles_);
  for (const Span& span : living_.spans)
    for (uint32_t i = 0; i < span.count; ++i)
      result.push_back(pool[span.base + (span.first + i) % span.capacity]);
  return result;
}

uint64_t Simulation::state_hash() const {
  uint64_t hash = 0xcbf29ce484222325;
  const auto states = particles();
  for (const std::byte byte : std::as_bytes(std::span(states)))
    hash = (hash ^ uint64_t(byte)) * 0x100000001b3;
  return hash;
}

void Simulation::count_demand(uint32_t tick, bool seeking) {
  std::vector<uint64_t> longest(calls_.size(), 0);
  for (CallState& call : calls_) call.demand.awake = false, call.demand.bytes = 0;
  std::vector<uint64_t> living(calls_.size(), 0), dispatches(calls_.size(), seeking ? 1 : 0);
  if (!seeking)
    for (const SpanList* list : {&moving_, &fresh_}) {
      std::vector<bool> takes_part(calls_.size(), false);
      for (const Span& span : list->spans) takes_part[emitters_[span.emitter].call] = true;
      for (size_t i = 0; i < calls_.size(); ++i) dispatches[i] += takes_part[i];
    }
  for (const Span& span : living_.spans) {
    const EmitterState& emitter = emitters_[span.emitter];
    InstanceDemand& demand = calls_[emitter.call].demand;
    demand.awake = true;
    demand.bytes += uint64_t(span.capacity) * sizeof(Particle);
    living[emitter.call] += span.count;
    const uint64_t ticks = seeking ? std::min(local_tick(emitter, tick), emitter.max_life) : 1;
    longest[emitter.call] = std::max(longest[emitter.call], ticks);
  }
  for (size_t i = 0; i < calls_.size(); ++i) {
    CallState& call = calls_[i];
    if (call.demand.awake) {
      call.demand.dispatches += dispatches[i];
      call.demand.ticks_simulated += longest[i];
      call.demand.why = fmt::format("has {} particles", living[i]);
    } else {
      call.demand.why = tick < call.call.tick   ? fmt::format("starts at tick {}", call.call.tick)
                        : tick > call.last_tick ? fmt::format("finished at tick {}", call.last_tick)
                                                : "between births";
    }
  }
}

std::vector<InstanceDemand> Simulation::demand() const {
  std::vector<InstanceDemand> result;
  for (const CallState& call : calls_) result.push_back(call.demand);
  return result;
}

}  // namespace plume
