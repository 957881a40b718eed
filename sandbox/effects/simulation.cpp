#include "sandbox/effects/simulation.h"

#include <algorithm>

namespace plume {
namespace {

using shared::Particle;
using shared::Span;

struct KernelPush {
  uint32_t threads, first_group;
};

struct CardsPush {
  KernelPush kernel;
  uint32_t first_card, first_body;
};

KernelPush push_of(const SpanList::Kernel& kernel) {
  return {.threads = kernel.threads, .first_group = kernel.first_group};
}

uint32_t motion_kernel(uint32_t features) {
  return features & ~shared::kUsesDisplacement;
}

}  // namespace

Simulation::Simulation(gpu::Device& device, gpu::Pipelines& pipelines, std::vector<Call> calls,
                       uint32_t scene_seed, glm::vec3 wind, const std::vector<Solid>& solids,
                       glm::vec3 sun_direction)
    : device_(device), pipelines_(pipelines), tables_(solids) {
  instances_ = make_instances(std::move(calls), scene_seed, wind, solids, sun_direction, tables_, meshes_);
  if (instances_.emitters.empty()) return;
  for (const EmitterState& emitter : instances_.emitters) count_loops(emitter);
  tables_.upload(device);
  meshes_.upload(device);
}

/// An emitter's slots carry its ancestors' motion too.
void Simulation::count_loops(const EmitterState& emitter) {
  const CallState& instance = instances_.calls[emitter.call];
  const uint32_t path_keys = instance.call.path ? uint32_t(instance.call.path->keys().size()) : 0;
  LoopsPerTick& loops = loops_[motion_kernel(emitter.features)];
  for (uint32_t index = emitter.index;; index = instance.described()[index].parent->index) {
    loops.widen({instances_.emitter_of(emitter.call, index).data, path_keys});
    if (!instance.described()[index].parent) break;
  }
}

/// A particle is a function of its own tick, so what reached that tick has its state whoever brought it
/// there.
void Simulation::adopt(Simulation& old, const std::vector<std::optional<uint32_t>>& was) {
  for (EmitterState& emitter : instances_.emitters) {
    if (!was[emitter.call]) continue;
    const Effect& now = *instances_.calls[emitter.call].call.effect;
    const Effect& then = *old.instances_.calls[*was[emitter.call]].call.effect;
    const auto found = std::ranges::find(then.emitters, now.emitters[emitter.index].name, &Emitter::name);
    const size_t index = size_t(found - then.emitters.begin());
    if (found == then.emitters.end() || !same_states(now, emitter.index, then, index)) continue;
    const EmitterState& same = old.instances_.emitter_of(*was[emitter.call], uint32_t(index));
    emitter.reached = same.reached;
    emitter.base = same.base;
  }
  particles_ = std::move(old.particles_);
}

/// Gives every emitter that is awake its slots. Those that were awake before keep their particles: returns
/// what is to be copied from the old pool.
std::vector<vk::BufferCopy> Simulation::lay_out_pool() {
  std::vector<vk::BufferCopy> kept;
  uint32_t base = 0;
  for (EmitterState& emitter : instances_.emitters) {
    if (!emitter.wanted) {
      emitter.reached.reset();
      continue;
    }
    if (emitter.reached && emitter.slots() > 0)
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
  return kept;
}

/// What the device knows of emitters: of those awake and of their ancestors, who need not be.
void Simulation::fill_tables() {
  std::vector<bool> known(instances_.emitters.size());
  for (size_t i = 0; i < instances_.emitters.size(); ++i) {
    if (!instances_.emitters[i].wanted) continue;
    known[i] = true;
    for (const EmitterState* e = &instances_.emitters[i]; instances_.described(*e).parent;) {
      e = &instances_.emitter_of(e->call, instances_.described(*e).parent->index);
      known[size_t(e - instances_.emitters.data())] = true;
    }
  }
  uint32_t places = 0;
  for (size_t i = 0; i < instances_.emitters.size(); ++i)
    if (known[i]) instances_.emitters[i].place = places++;
  std::vector<shared::EmitterData> data;
  std::vector<glm::vec4> curves;
  std::vector<shared::PathKey> paths;
  for (size_t i = 0; i < instances_.emitters.size(); ++i) {
    if (!known[i]) continue;
    const EmitterState& emitter = instances_.emitters[i];
    data.push_back(emitter.data);
    if (const auto& path = instances_.calls[emitter.call].call.path) {
      data.back().path_first = uint32_t(paths.size());
      data.back().path_count = uint32_t(path->keys().size());
      for (const Path::Key& key : path->keys()) paths.push_back({float(key.tick), key.position});
    }
    if (const auto& parent = instances_.described(emitter).parent)
      data.back().parent = instances_.emitter_of(emitter.call, parent->index).place;
    curves.insert(curves.end(), emitter.curves.begin(), emitter.curves.end());
  }
  if (data.empty()) {  // all asleep
    for (gpu::Buffer* unused : {&emitter_data_, &curves_, &path_keys_, &births_buffer_}) *unused = {};
    return;
  }
  upload(device_, emitter_data_, "emitters", data);
  upload(device_, curves_, "curves", curves);
  if (!paths.empty()) upload(device_, path_keys_, "path keys", paths);
}

Span Simulation::span_of(const EmitterState& emitter, uint64_t first, uint64_t end) const {
  return {.emitter = emitter.place,
          .first = uint32_t(first),
          .count = uint32_t(end - first),
          .base = emitter.base,
          .capacity = uint32_t(emitter.schedule.capacity()),
          .first_slot = uint32_t(first % emitter.schedule.capacity()),
          .tick = *emitter.wanted,
          .per_root = uint32_t(emitter.lineage.per_root)};
}

/// How many roots had been born before each tick from the span's first birth to its own tick.
void Simulation::add_births(Span& span, const EmitterState& emitter) {
  span.births_base = uint32_t(births_.size());
  span.births_tick = emitter.schedule.birth_tick(span.first);
  span.births_count = span.tick - span.births_tick + 1;
  const auto roots = [&](uint32_t tick) { return uint32_t(emitter.schedule.births(tick) / span.per_root); };
  births_.push_back(span.births_tick == 0 ? 0 : roots(span.births_tick - 1));
  for (uint32_t tick = span.births_tick; tick <= span.tick; ++tick) births_.push_back(roots(tick));
}

/// Births [first, end), from their ancestors' births on.
void Simulation::add_seek(const EmitterState& emitter, uint64_t first, uint64_t end) {
  if (first == end) return;
  Span span = span_of(emitter, first, end);
  add_births(span, emitter);
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
  for (EmitterState& emitter : instances_.emitters) {
    if (!emitter.wanted) continue;
    const uint32_t tick = *emitter.wanted;
    const uint64_t first = emitter.schedule.first_alive(tick), end = emitter.schedule.births(tick);
    Span span = span_of(emitter, first, end);
    if (emitter.is_analytic()) add_births(span, emitter);
    if (makes_pieces(emitter.card_kernel))
      pieces_.push_back(
          {.span = span,
           .triangles = meshes_.most_triangles(emitter.data.look_mesh, emitter.data.look_meshes)});
    else
      living_.add(emitter.card_kernel, span, threads_a_birth(emitter.card_kernel, emitter.data.cards_each));
    emitter.ticks = emitter.dispatches = 0;
    if (emitter.is_analytic()) emitter.reached = tick;
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
  if (!births_.empty()) upload(device_, births_buffer_, "births", births_);
}

/// What any kernel may ask for. A descriptor needs something to point at where there is nothing.
gpu::Bindings Simulation::bindings(const SpanList& list) const {
  const auto or_any = [&](const gpu::Buffer& buffer) { return buffer ? &buffer : &emitter_data_; };
  gpu::Bindings bound = list.bindings();
  bound.insert(bound.end(), {{"Particles", or_any(particles_)},
                             {"Emitters", &emitter_data_},
                             {"Curves", &curves_},
                             {"Births", or_any(births_buffer_)},
                             {"PathKeys", or_any(path_keys_)},
                             {"MeshRanges", or_any(meshes_.ranges())},
                             {"MeshTriangles", or_any(meshes_.triangles())}});
  return bound;
}

void Simulation::record(gpu::Pass& pass, const char* shader, const SpanList& list) const {
  gpu::Bindings bound = tables_.bindings();
  for (const gpu::Binding& own : bindings(list)) bound.push_back(own);
  for (const SpanList::Kernel& kernel : list.kernels())
    pass.dispatch(pipelines_.compute(shader, {kernel.id}), bound, push_of(kernel),
                  {gpu::groups(kernel.threads, shared::kSpanGroup), 1, 1});
}

std::vector<gpu::PassTime> Simulation::go_to(uint32_t tick, const Views& views) {
  const bool jumped = !tick_ || tick != *tick_ + 1;
  pass_time(instances_, tick_, tick, views, script_);
  const bool moved = decide(instances_, tick, views) || !tick_;  // at first there are no tables
  gpu::Buffer old;
  std::vector<vk::BufferCopy> kept;
  if (moved) {
    old = std::move(particles_);
    kept = lay_out_pool();
    fill_tables();
  }
  plan();
  tick_ = tick;
  count_demand(instances_, tick, jumped);
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

void Simulation::start_over() {
  forget(instances_);
  tick_.reset();
}

std::vector<gpu::PassTime> Simulation::seek(uint32_t tick) {
  for (EmitterState& emitter : instances_.emitters) emitter.reached.reset();
  return go_to(tick);
}

uint32_t Simulation::cards() const {
  uint32_t cards = 0;
  for (const SpanList::Kernel& kernel : living_.kernels()) cards += cards_of(kernel);
  return cards;
}

void Simulation::record_cards(gpu::Pass& pass, const gpu::Buffer& view, const gpu::Buffer& cards,
                              uint32_t first_card, const gpu::Buffer* bodies) const {
  gpu::Bindings bound = bindings(living_);
  // Bodies are unused in one variant, but a descriptor points somewhere.
  bound.insert(bound.end(), {{"View", &view}, {"Cards", &cards}, {"Bodies", bodies ? bodies : &cards}});
  uint32_t first_body = 0;
  for (const SpanList::Kernel& kernel : living_.kernels()) {
    pass.dispatch(
        pipelines_.compute(card_shader(kernel.id), {card_features(kernel.id), bodies ? 1u : 0u}), bound,
        CardsPush{.kernel = push_of(kernel), .first_card = first_card + first_body, .first_body = first_body},
        {gpu::groups(kernel.threads, shared::kSpanGroup), 1, 1});
    first_body += cards_of(kernel);
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

std::vector<Particle> Simulation::particles() const {
  std::vector<Particle> result;
  if (!particles_) return result;
  const auto pool = gpu::read<Particle>(device_, particles_);
  for (const EmitterState& emitter : instances_.emitters) {
    if (!emitter.wanted || emitter.is_analytic()) continue;
    const uint64_t first = emitter.schedule.first_alive(*emitter.wanted);
    for (uint64_t birth = first; birth < first + emitter.living(); ++birth)
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

std::vector<InstanceDemand> Simulation::demand() const {
  std::vector<InstanceDemand> result;
  for (const CallState& instance : instances_.calls) result.push_back(instance.demand);
  return result;
}

}  // namespace plume
