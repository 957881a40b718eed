#include "sandbox/effects/simulation.h"

#include <fmt/format.h>

#include <algorithm>

#include "sandbox/effects/influence.h"

namespace plume {
namespace {

using shared::Particle;
using shared::Span;

struct KernelPush {
  uint32_t threads, first_span, spans;
};

struct CardsPush {
  KernelPush kernel;
  uint32_t first_card, first_body;
};

constexpr uint32_t kGroupSize = 64;

KernelPush push_of(const SpanList::Kernel& kernel) {
  return {.threads = kernel.threads, .first_span = kernel.first_span, .spans = kernel.spans};
}

SpawnSchedule schedule_of(const Call& call, const Lineage& lineage) {
  return SpawnSchedule(lineage.spawn, {.path = call.path ? &*call.path : nullptr,
                                       .stop_tick = call.stop_tick ? *call.stop_tick - call.tick : UINT32_MAX,
                                       .per_root = lineage.per_root,
                                       .life = lineage.life});
}

Source source_of(const Look& look) {
  return look.distortion_deg > 0.0f ? Source::kHaze : plume::source_of(look.transmission);
}

/// What turns particles into cards; pieces are opaque and are drawn themselves.
enum class CardKind : uint32_t { kSprites, kMeshes, kRibbons, kPieces };
constexpr std::array kCardShaders{"effects/cards.comp", "effects/cards_mesh.comp",
                                  "effects/cards_ribbon.comp"};

CardKind card_kind(const Look& look) {
  if (look.opaque) return CardKind::kPieces;
  if (look.ribbon) return CardKind::kRibbons;
  return look.meshes.empty() ? CardKind::kSprites : CardKind::kMeshes;
}

/// Kernels of cards in the order in which cards lie: those of one source stand together.
///   source << kSourceShift | CardKind << kKindShift | features
constexpr uint32_t kSourceShift = 30, kKindShift = 28;
constexpr uint32_t kFeatureBits = (1u << kKindShift) - 1;

uint32_t cards_kernel(const Emitter& emitter) {
  return uint32_t(source_of(emitter.look)) << kSourceShift | uint32_t(card_kind(emitter.look)) << kKindShift |
         (features_of(emitter) & shared::kUsesDisplacement);
}

CardKind card_kind(uint32_t cards_kernel) {
  return CardKind(cards_kernel >> kKindShift & 3u);
}

/// A mesh's faces are shared out; a ribbon's segment and all else are a thread's.
uint32_t threads_a_birth(uint32_t cards_kernel, uint32_t cards_each) {
  return card_kind(cards_kernel) == CardKind::kMeshes ? cards_each : 1;
}

uint32_t cards_of_kernel(const SpanList::Kernel& kernel) {
  return card_kind(kernel.id) == CardKind::kRibbons ? 2 * kernel.threads : kernel.threads;
}

bool sees(const Views& views, const Bounds& bounds) {
  return !views ||
         std::ranges::any_of(*views, [&](const ViewVolume& view) { return may_touch(view, bounds); });
}

uint32_t motion_kernel(uint32_t features) {
  return features & ~shared::kUsesDisplacement;
}

}  // namespace

Simulation::Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls,
                       uint32_t scene_seed, glm::vec3 wind, const std::vector<Solid>& solids,
                       glm::vec3 sun_direction)
    : device_(device), pipelines_(pipelines), tables_(solids) {
  struct Member {
    uint32_t call, index;
    uint32_t cards;
  };
  std::vector<Member> members;
  std::vector<std::vector<Bounds>> drawn;  // by call and emitter
  for (Call& call : calls) {
    drawn.push_back(emitter_bounds(*call.effect, {.position = call.position,
                                                  .yaw_deg = call.yaw_deg,
                                                  .path = call.path ? &*call.path : nullptr,
                                                  .wind = wind,
                                                  .solids = &solids}));
    for (uint32_t e = 0; e < call.effect->emitters.size(); ++e)
      members.push_back({uint32_t(calls_.size()), e, cards_kernel(call.effect->emitters[e])});
    Clock clock(call.tick);
    for (const Freeze& freeze : call.freezes) clock.freeze(freeze);
    calls_.push_back({.call = std::move(call),
                      .clock = std::move(clock),
                      .first_emitter = uint32_t(members.size() - call.effect->emitters.size()),
                      .demand = {}});
    calls_.back().demand.name = calls_.back().call.name;
    calls_.back().demand.called = true;
  }
  std::ranges::stable_sort(members, {}, &Member::cards);

  emitter_of_call_.resize(members.size());
  for (const auto& [call, index, cards] : members) {
    CallState& state = calls_[call];
    const std::vector<Emitter>& emitters = state.call.effect->emitters;
    const Lineage lineage = lineage_of(emitters, index);
    emitter_of_call_[state.first_emitter + index] = uint32_t(emitters_.size());
    emitters_.push_back({.call = call,
                         .index = index,
                         .cards = cards,
                         .features = features_of(state.call, index),
                         .schedule = schedule_of(state.call, lineage),
                         .lineage = lineage,
                         .data = emitter_data(state.call, index, scene_seed, wind, meshes_),
                         .curves = bake_curves(emitters[index].look)});
    emitters_.back().bounds = influence(emitters[index].look, drawn[call][index], sun_direction);
    tables_.fill(emitters[index], emitters_.back().data, &drawn[call][index]);
    state.last_tick = std::max(state.last_tick, emitters_.back().schedule.last_tick());
  }
  if (emitters_.empty()) return;
  for (const EmitterState& emitter : emitters_) {
    LoopsPerTick& loops = loops_[motion_kernel(emitter.features)];
    const std::vector<Emitter>& family = calls_[emitter.call].call.effect->emitters;
    for (const Emitter* e = &family[emitter.index];; e = &family[e->parent->index]) {
      const auto& path = calls_[emitter.call].call.path;
      loops.widen({emitter_of(emitter.call, uint32_t(e - family.data())).data,
                   path ? uint32_t(path->keys().size()) : 0});
      if (!e->parent) break;
    }
  }
  tables_.upload(device);
  meshes_.upload(device);
}

bool Simulation::is_seen(uint32_t call, const Views& views) const {
  const size_t first = calls_[call].first_emitter, count = calls_[call].call.effect->emitters.size();
  for (size_t i = first; i < first + count; ++i)
    if (sees(views, emitters_[emitter_of_call_[i]].bounds)) return true;
  return false;
}

/// Between the tick before and this one time stood still for what pauses off screen where nobody saw it.
/// Going back forgets what came later.
void Simulation::pass_time(uint32_t tick, const Views& views) {
  for (uint32_t i = 0; i < calls_.size(); ++i) {
    CallState& call = calls_[i];
    if (call.call.effect->off_screen != OffScreen::kPause) continue;
    if (tick_ && *tick_ > tick) forget_after(call, tick);
    for (uint32_t t = std::max(tick_.value_or(0), call.call.tick) + 1; t <= tick; ++t)
      if (!is_seen(i, t < tick && script_ ? script_(t) : views)) call.clock.stand_still(t, t + 1);
  }
}

/// What the scene says of the time to come stays.
void Simulation::forget_after(CallState& call, uint32_t tick) {
  call.clock.forget_from(tick + 1);
  for (const Freeze& freeze : call.call.freezes) call.clock.freeze(freeze);
}

void Simulation::set_frozen(uint32_t call, bool frozen) {
  forget_after(calls_.at(call), tick());
  if (frozen) calls_[call].clock.freeze({tick(), UINT32_MAX - 1});
}

/// Whether anything can be alive at the emitter's own tick.
bool Simulation::has_living(const EmitterState& emitter, uint32_t tick) const {
  return emitter.schedule.births(tick) > emitter.schedule.first_alive(tick);
}

/// Gives every emitter that is awake its slots. Those that were awake before keep their particles: returns
/// what is to be copied from the old pool.
std::vector<vk::BufferCopy> Simulation::lay_out_pool() {
  std::vector<vk::BufferCopy> kept;
  uint32_t base = 0;
  for (EmitterState& emitter : emitters_) {
    if (!emitter.wanted) {
      emitter.reached.reset();
      continue;
    }
    if (emitter.reached)
      kept.push_back({.srcOffset = uint64_t(emitter.base) * sizeof(Particle),
                      .dstOffset = uint64_t(base) * sizeof(Particle),
                      .size = uint64_t(emitter.slots()) * sizeof(Particle)});
    emitter.base = base;
    base += emitter.slots();
  }
  particles_ = gpu::Buffer();
  if (base > 0)
    particles_ = gpu::Buffer(
        device_, {.owner = "particles", .label = "particles", .bytes = uint64_t(base) * sizeof(Particle)});
  else  // all asleep
    for (gpu::Buffer* unused : {&emitter_data_, &curves_, &path_keys_, &births_buffer_}) *unused = {};
  return kept;
}

/// What the device knows of emitters: of those awake and of their ancestors, who need not be.
void Simulation::fill_tables() {
  std::vector<bool> known(emitters_.size());
  for (size_t i = 0; i < emitters_.size(); ++i) {
    if (!emitters_[i].wanted) continue;
    known[i] = true;
    const auto& of_effect = calls_[emitters_[i].call].call.effect->emitters;
    for (const Emitter* e = &of_effect[emitters_[i].index]; e->parent; e = &of_effect[e->parent->index])
      known[size_t(&emitter_of(emitters_[i].call, e->parent->index) - emitters_.data())] = true;
  }
  uint32_t places = 0;
  for (size_t i = 0; i < emitters_.size(); ++i)
    if (known[i]) emitters_[i].place = places++;
  std::vector<shared::EmitterData> data;
  std::vector<glm::vec4> curves;
  std::vector<shared::PathKey> paths;
  for (size_t i = 0; i < emitters_.size(); ++i) {
    if (!known[i]) continue;
    const EmitterState& emitter = emitters_[i];
    data.push_back(emitter.data);
    if (const auto& path = calls_[emitter.call].call.path) {
      data.back().path_first = uint32_t(paths.size());
      data.back().path_count = uint32_t(path->keys().size());
      for (const Path::Key& key : path->keys()) paths.push_back({float(key.tick), key.position});
    }
    if (const auto& parent = calls_[emitter.call].call.effect->emitters[emitter.index].parent)
      data.back().parent = emitter_of(emitter.call, parent->index).place;
    curves.insert(curves.end(), emitter.curves.begin(), emitter.curves.end());
  }
  if (data.empty()) return;
  upload(device_, emitter_data_, "emitters", data);
  upload(device_, curves_, "curves", curves);
  if (paths.empty()) paths.push_back({});  // a descriptor needs something to point at
  upload(device_, path_keys_, "path keys", paths);
}

/// Births that may be alive at the emitter's tick.
uint32_t Simulation::living(const EmitterState& emitter) const {
  const uint32_t tick = *emitter.wanted;
  return uint32_t(emitter.schedule.births(tick) - emitter.schedule.first_alive(tick));
}

Span Simulation::span_of(const EmitterState& emitter, uint64_t first, uint64_t end) const {
  return {.emitter = emitter.place,
          .first = uint32_t(first),
          .count = uint32_t(end - first),
          .base = emitter.base,
          .capacity = emitter.slots(),
          .first_slot = uint32_t(first % emitter.slots()),
          .tick = *emitter.wanted,
          .per_root = uint32_t(emitter.lineage.per_root)};
}

/// Births [first, end), from their ancestors' births on.
void Simulation::add_seek(const EmitterState& emitter, uint64_t first, uint64_t end) {
  if (first == end) return;
  Span span = span_of(emitter, first, end);
  span.births_base = uint32_t(births_.size());
  span.births_tick = emitter.schedule.birth_tick(first);
  span.births_count = span.tick - span.births_tick + 1;
  const auto roots = [&](uint32_t tick) { return uint32_t(emitter.schedule.births(tick) / span.per_root); };
  births_.push_back(span.births_tick == 0 ? 0 : roots(span.births_tick - 1));
  for (uint32_t tick = span.births_tick; tick <= span.tick; ++tick) births_.push_back(roots(tick));
  const uint32_t ticks = loops_.at(motion_kernel(emitter.features)).ticks_per_dispatch();
  const uint32_t last = span.tick;
  size_t dispatch = 0;
  for (uint64_t from = span.births_tick; from <= last; from += ticks, ++dispatch) {
    span.resume = dispatch == 0 ? 0 : uint32_t(from);
    span.tick = uint32_t(std::min<uint64_t>(from + ticks - 1, last));
    if (dispatch == seeks_.size()) seeks_.emplace_back();
    seeks_[dispatch].add(motion_kernel(emitter.features), span);
  }
}

/// Which births are stepped and which are sought so that every emitter reaches what is wanted of it.
void Simulation::plan() {
  living_.clear(), pieces_.clear(), steps_.clear(), births_.clear();
  for (SpanList& seeks : seeks_) seeks.clear();
  for (EmitterState& emitter : emitters_) {
    if (!emitter.wanted) continue;
    const uint32_t tick = *emitter.wanted;
    const uint64_t first = emitter.schedule.first_alive(tick), end = emitter.schedule.births(tick);
    if (card_kind(emitter.cards) != CardKind::kPieces)
      living_.add(emitter.cards, span_of(emitter, first, end),
                  threads_a_birth(emitter.cards, emitter.data.cards_each));
    else
      pieces_.push_back(
          {.span = span_of(emitter, first, end),
           .triangles = meshes_.most_triangles(emitter.data.look_mesh, emitter.data.look_meshes)});
    emitter.ticks = emitter.dispatches = 0;
    if (emitter.reached == tick) continue;
    uint64_t fresh = first;  // those after it come by seeking
    if (tick > 0 && emitter.reached == tick - 1) {
      fresh = std::max(first, emitter.schedule.births(tick - 1));
      steps_.add(motion_kernel(emitter.features), span_of(emitter, first, fresh));
      emitter.ticks = 1;
      emitter.dispatches = fresh > first;
    } else {
      emitter.ticks = std::min(tick, emitter.lineage.life);
    }
    add_seek(emitter, fresh, end);
    emitter.dispatches += end > fresh;
    emitter.reached = tick;
  }
  living_.upload(device_, "living"), steps_.upload(device_, "steps");
  for (SpanList& seeks : seeks_) seeks.upload(device_, "seeks");
  upload(device_, births_buffer_, "births", births_);
}

/// Where there are no meshes a descriptor still needs something to point at.
gpu::Bindings Simulation::mesh_bindings() const {
  return {{"MeshRanges", meshes_.empty() ? &emitter_data_ : &meshes_.ranges()},
          {"MeshTriangles", meshes_.empty() ? &emitter_data_ : &meshes_.triangles()}};
}

void Simulation::record(gpu::Pass& pass, const char* shader, const SpanList& list) const {
  gpu::Bindings bindings = tables_.bindings();
  for (const gpu::Binding& mesh : mesh_bindings()) bindings.push_back(mesh);
  bindings.insert(bindings.end(), {{"Particles", &particles_},
                                   {"Spans", &list.buffer()},
                                   {"Emitters", &emitter_data_},
                                   {"Births", &births_buffer_},
                                   {"PathKeys", &path_keys_}});
  for (const SpanList::Kernel& kernel : list.kernels())
    pass.dispatch(pipelines_.compute(shader, {kernel.id}), bindings, push_of(kernel),
                  {gpu::groups(kernel.threads, kGroupSize), 1, 1});
}

std::vector<gpu::PassTime> Simulation::go_to(uint32_t tick, const Views& views) {
  const bool jumped = !tick_ || tick != *tick_ + 1;
  pass_time(tick, views);
  bool moved = false;
  for (EmitterState& emitter : emitters_) {
    const std::optional<uint32_t> local = calls_[emitter.call].clock.local(tick);
    const bool seen = sees(views, emitter.bounds);
    emitter.wanted = local && seen && has_living(emitter, *local) ? local : std::nullopt;
    moved |= emitter.wanted.has_value() != emitter.reached.has_value();
  }
  gpu::Buffer old;
  std::vector<vk::BufferCopy> kept;
  if (moved) {
    old = std::move(particles_);
    kept = lay_out_pool();
    fill_tables();
  }
  plan();
  tick_ = tick;
  count_demand(tick, jumped);
  const bool moves =
      !steps_.empty() || std::ranges::any_of(seeks_, [](const SpanList& s) { return !s.empty(); });
  if (kept.empty() && !moves) return {};
  gpu::Frame frame(device_, pipelines_);
  if (!kept.empty())
    frame.pass("keep particles",
               [&](gpu::Pass& pass) { pass.commands().copyBuffer(old.vk(), particles_.vk(), kept); });
  if (moves)
    frame.pass("simulate", [&](gpu::Pass& pass) {  // both at once: they touch different slots
      record(pass, "effects/tick.comp", steps_);
      for (const SpanList& seeks : seeks_) {
        if (&seeks != &seeks_.front() && !seeks.empty()) pass.barrier();  // they go on from there
        record(pass, "effects/seek.comp", seeks);
      }
    });
  return frame.finish();
}

std::vector<gpu::PassTime> Simulation::seek(uint32_t tick) {
  for (EmitterState& emitter : emitters_) emitter.reached.reset();
  return go_to(tick);
}

uint32_t Simulation::cards() const {
  uint32_t cards = 0;
  for (const SpanList::Kernel& kernel : living_.kernels()) cards += cards_of_kernel(kernel);
  return cards;
}

void Simulation::record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards,
                              uint32_t first_card, const gpu::Buffer* bodies) const {
  uint32_t first_body = 0;
  for (const SpanList::Kernel& kernel : living_.kernels()) {
    gpu::Bindings bindings = mesh_bindings();
    bindings.insert(bindings.end(), {{"Particles", &particles_},
                                     {"Spans", &living_.buffer()},
                                     {"Emitters", &emitter_data_},
                                     {"View", &view},
                                     {"Curves", &curves_},
                                     {"Cards", &cards},
                                     // Unused in that variant, but a descriptor points somewhere.
                                     {"Bodies", bodies ? bodies : &cards}});
    pass.dispatch(
        pipelines_.compute(kCardShaders[size_t(card_kind(kernel.id))],
                           {kernel.id & kFeatureBits, bodies ? 1u : 0u}),
        bindings,
        CardsPush{.kernel = push_of(kernel), .first_card = first_card + first_body, .first_body = first_body},
        {gpu::groups(kernel.threads, kGroupSize), 1, 1});
    first_body += cards_of_kernel(kernel);
  }
}

Simulation::Pieces Simulation::pieces() const {
  if (pieces_.empty()) return {};
  return {.draws = pieces_,
          .particles = &particles_,
          .emitters = &emitter_data_,
          .curves = &curves_,
          .mesh_ranges = &meshes_.ranges(),
          .mesh_triangles = &meshes_.triangles()};
}

std::array<uint32_t, kSources> Simulation::cards_by_source() const {
  std::array<uint32_t, kSources> result{};
  for (const EmitterState& emitter : emitters_)
    if (emitter.wanted) result[emitter.cards >> kSourceShift] += cards_of(emitter);
  return result;
}

std::vector<Simulation::EmitterCards> Simulation::cards_by_emitter() const {
  std::vector<EmitterCards> result(emitters_.size());
  uint32_t first = 0;
  for (const EmitterState& emitter : emitters_) {  // by source; the scene's order is that of calls
    if (!emitter.wanted) continue;
    const Call& call = calls_[emitter.call].call;
    const Emitter& described = call.effect->emitters[emitter.index];
    EmitterCards& cards = result[calls_[emitter.call].first_emitter + emitter.index];
    cards = {.first = first,
             .count = cards_of(emitter),
             .call = emitter.call,
             .emitter = &described,
             .origin = emitter.data.origin,
             .draw_order = call.draw_order + described.look.draw_order};
    first += cards.count;
  }
  std::erase_if(result, [](const EmitterCards& cards) { return cards.count == 0; });
  return result;
}

std::vector<Particle> Simulation::particles() const {
  std::vector<Particle> result;
  if (!particles_) return result;
  const auto pool = gpu::read<Particle>(device_, particles_);
  for (const EmitterState& emitter : emitters_) {
    if (!emitter.wanted) continue;
    const uint64_t first = emitter.schedule.first_alive(*emitter.wanted);
    for (uint64_t birth = first; birth < first + living(emitter); ++birth)
      result.push_back(pool[emitter.base + birth % emitter.slots()]);
  }
  return result;
}

uint64_t Simulation::state_hash() const {
  uint64_t hash = 0xcbf29ce484222325;
  const auto states = particles();
  for (const std::byte byte : std::as_bytes(std::span(states)))
    hash = (hash ^ uint64_t(byte)) * 0x100000001b3;
  return hash;
}

std::string Simulation::why_asleep(const CallState& call, uint32_t tick) const {
  const std::optional<uint32_t> local = call.clock.local(tick);
  if (!local) return fmt::format("starts at tick {}", call.call.tick);
  if (*local > call.last_tick) return fmt::format("finished at its tick {}", call.last_tick);
  bool living = false;
  for (uint32_t e = 0; e < call.call.effect->emitters.size(); ++e)
    living |= has_living(emitters_[emitter_of_call_[call.first_emitter + e]], *local);
  if (!living) return "between births";
  return call.clock.stood_still(tick) ? fmt::format("out of view, stopped at its tick {}", *local)
                                      : "out of view";
}

/// `jumped`: this tick does not follow the one before.
void Simulation::count_demand(uint32_t tick, bool jumped) {
  struct Count {
    uint64_t living = 0, ticks = 0, ticks_saved = 0, dispatches = 0;
    bool resident = false;
  };
  std::vector<Count> counts(calls_.size());
  for (CallState& call : calls_) call.demand.bytes = call.demand.bytes_saved = 0;
  for (const EmitterState& emitter : emitters_) {
    const CallState& call = calls_[emitter.call];
    InstanceDemand& demand = calls_[emitter.call].demand;
    Count& count = counts[emitter.call];
    const uint64_t bytes = uint64_t(emitter.slots()) * sizeof(Particle);
    if (emitter.wanted) {
      demand.bytes += bytes;
      count.resident = true;
      count.living += living(emitter);
      count.ticks = std::max<uint64_t>(count.ticks, emitter.ticks);
      count.dispatches = std::max<uint64_t>(count.dispatches, emitter.dispatches);
    } else if (const auto local = call.clock.local(tick); local && has_living(emitter, *local)) {
      demand.bytes_saved += bytes;
      count.ticks_saved =
          std::max<uint64_t>(count.ticks_saved, jumped ? std::min(*local, emitter.lineage.life) : 1);
    }
  }
  for (size_t i = 0; i < calls_.size(); ++i) {
    CallState& call = calls_[i];
    InstanceDemand& demand = call.demand;
    const Count& count = counts[i];
    demand.dispatches += count.dispatches;
    demand.ticks_simulated += count.ticks;
    demand.ticks_saved += count.ticks_saved;
    const bool frozen = count.resident && count.ticks == 0 && call.clock.stood_still(tick);
    demand.awake = count.resident && !frozen;
    demand.why = frozen           ? fmt::format("frozen at its tick {}", *call.clock.local(tick))
                 : count.resident ? fmt::format("has {} particles", count.living)
                                  : why_asleep(call, tick);
  }
}

std::vector<InstanceDemand> Simulation::demand() const {
  std::vector<InstanceDemand> result;
  for (const CallState& call : calls_) result.push_back(call.demand);
  return result;
}

}  // namespace plume
