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

constexpr uint32_t kGroupSize = 64;

/// A host-visible buffer that holds `data`, made anew only when it has outgrown the old one.
template <class T>
void upload(gpu::Device& device, gpu::Buffer& buffer, const char* label, const std::vector<T>& data) {
  const uint64_t bytes = std::max<uint64_t>(data.size() * sizeof(T), 16);
  if (buffer.bytes() < bytes)
    buffer = gpu::Buffer(device, {.owner = "simulation", .label = label, .bytes = bytes + bytes / 2, .host_visible = true});
  std::copy(data.begin(), data.end(), buffer.mapped<T>().begin());
}

}  // namespace

Simulation::Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls, uint32_t scene_seed,
                       glm::vec3 wind)
    : device_(device), pipelines_(pipelines) {
  std::vector<shared::EmitterData> data;
  std::vector<glm::vec4> curves;
  for (Call& call : calls) {
    CallState state{.call = std::move(call), .last_tick = 0, .demand = {}};
    state.demand.name = state.call.name;
    state.demand.called = true;
    for (uint32_t e = 0; e < state.call.effect->emitters.size(); ++e) {
      const Emitter& emitter = state.call.effect->emitters[e];
      data.push_back(emitter_data(state.call, e, scene_seed, wind));
      const CurveTable table = bake_curves(emitter.look);
      curves.insert(curves.end(), table.begin(), table.end());
      emitters_.push_back({.call = uint32_t(calls_.size()),
                           .schedule = SpawnSchedule(emitter.spawn),
                           .max_life = emitter.spawn.life_ticks.max});
      state.last_tick = std::max(state.last_tick, state.call.tick + emitters_.back().schedule.last_tick());
    }
    calls_.push_back(std::move(state));
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
  particles_ = gpu::Buffer();   // the old pool goes before the new one comes
  if (slots > 0)
    particles_ = gpu::Buffer(device_, {.owner = "simulation", .label = "particles", .bytes = slots * sizeof(Particle)});
  return true;
}

void Simulation::make_spans(uint32_t tick, bool with_births) {
  span_list_.clear();
  threads_ = 0;
  std::vector<uint32_t> births;
  uint32_t base = 0;
  for (uint32_t i = 0; i < emitters_.size(); ++i) {
    const EmitterState& emitter = emitters_[i];
    if (!emitter.awake) continue;
    const uint32_t local = local_tick(emitter, tick);
    const uint64_t first = emitter.schedule.first_alive(local), born = emitter.schedule.births(local);
    Span span{.emitter = i,
              .first = uint32_t(first),
              .count = uint32_t(born - first),
              .fresh = local > 0 ? uint32_t(emitter.schedule.births(local - 1)) : 0,
              .base = base,
              .capacity = uint32_t(emitter.schedule.capacity()),
              .offset = threads_,
              .births_base = uint32_t(births.size()),
              .births_tick = local - std::min(local, emitter.max_life),
              .births_count = 0};
    if (with_births) {
      for (uint32_t t = span.births_tick; t <= local; ++t) births.push_back(uint32_t(emitter.schedule.births(t)));
      span.births_count = uint32_t(births.size()) - span.births_base;
    }
    base += span.capacity;
    threads_ += span.count;
    span_list_.push_back(span);
  }
  upload(device_, spans_, "spans", span_list_);
  if (with_births) upload(device_, births_, "births", births);
}

std::vector<gpu::PassTime> Simulation::dispatch(const char* name, const char* shader, uint32_t tick) {
  if (threads_ == 0) return {};
  gpu::Frame frame(device_, pipelines_);
  frame.pass(name, [&](gpu::Pass& pass) {
    pass.dispatch(pipelines_.compute(shader),
                  {{"Particles", &particles_}, {"Spans", &spans_}, {"Emitters", &emitter_data_}, {"Births", &births_}},
                  SimulationPush{.threads = threads_, .span_count = uint32_t(span_list_.size()), .tick = tick},
                  {gpu::groups(threads_, kGroupSize), 1, 1});
  });
  return frame.finish();
}

std::vector<gpu::PassTime> Simulation::seek(uint32_t tick) {
  wake_and_sleep(tick);
  make_spans(tick, true);
  tick_ = tick;
  count_demand(tick, true);
  return dispatch("seek", "effects/seek.comp", tick);
}

std::vector<gpu::PassTime> Simulation::step() {
  const uint32_t tick = tick_.value() + 1;
  // The pool is laid out for what is awake: when that changes, everybody is brought to the new tick directly.
  if (wake_and_sleep(tick)) return seek(tick);
  make_spans(tick, false);
  tick_ = tick;
  count_demand(tick, false);
  return dispatch("step", "effects/tick.comp", tick);
}

std::vector<gpu::PassTime> Simulation::go_to(uint32_t tick) {
  if (tick_ == tick) return {};
  if (tick_ && tick == *tick_ + 1) return step();
  return seek(tick);
}

void Simulation::record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards,
                              uint32_t first_card) const {
  if (threads_ == 0) return;
  pass.dispatch(pipelines_.compute("effects/cards.comp"),
                {{"Particles", &particles_},
                 {"Spans", &spans_},
                 {"Emitters", &emitter_data_},
                 {"View", &view},
                 {"Curves", &curves_},
                 {"Cards", &cards}},
                SimulationPush{.threads = threads_, .span_count = uint32_t(span_list_.size()), .tick = first_card},
                {gpu::groups(threads_, kGroupSize), 1, 1});
}

std::vector<Particle> Simulation::particles() const {
  std::vector<Particle> result;
  if (threads_ == 0) return result;
  const auto pool = gpu::read<Particle>(device_, particles_);
  for (const Span& span : span_list_)
    for (uint32_t i = 0; i < span.count; ++i) result.push_back(pool[span.base + (span.first + i) % span.capacity]);
  return result;
}

uint64_t Simulation::state_hash() const {
  uint64_t hash = 0xcbf29ce484222325;
  const auto states = particles();
  for (const std::byte byte : std::as_bytes(std::span(states))) hash = (hash ^ uint64_t(byte)) * 0x100000001b3;
  return hash;
}

void Simulation::count_demand(uint32_t tick, bool seeking) {
  std::vector<uint64_t> longest(calls_.size(), 0);
  for (CallState& call : calls_) call.demand.awake = false, call.demand.bytes = 0;
  std::vector<uint64_t> living(calls_.size(), 0);
  for (const Span& span : span_list_) {
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
      call.demand.dispatches += 1;
      call.demand.ticks_simulated += longest[i];
      call.demand.why = fmt::format("has {} particles", living[i]);
    } else {
      call.demand.why = tick < call.call.tick    ? fmt::format("starts at tick {}", call.call.tick)
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
