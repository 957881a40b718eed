#include "sandbox/scene/stage.h"

#include <algorithm>
#include <numeric>

#include "sandbox/effects/puff_textures.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/debris.h"
#include "sandbox/scene/pane_card.h"
#include "sandbox/scene/view.h"

namespace plume {
namespace {

constexpr uint32_t kTextureSeed =
    1;  // one set of puffs for all scenes: the look of an effect does not depend on where it is

}  // namespace

Stage::Stage(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, Scene scene,
             const SceneEdits& edits)
    : device_(device),
      pipelines_(pipelines),
      library_(library),
      scene_(std::move(scene)),
      opaque_(device, scene_.solids),
      view_(device,
            {.owner = "scene", .label = "view", .bytes = sizeof(shared::ViewData), .host_visible = true}),
      seen_(device) {
  call_effects(effects_with(edits), edits, {});
  for (const Pane& pane : scene_.panes)
    (source_of(pane.transmission) == Source::kRgb ? rgb_panes_ : scalar_panes_).push_back(pane_card(pane));
}

/// Those that the scene calls, muted or not.
std::map<std::string, Effect> Stage::effects_with(const SceneEdits& edits) {
  std::map<std::string, Effect> effects;
  for (const Instance& instance : scene_.instances) {
    if (!instance.call_tick || effects.contains(instance.effect)) continue;
    if (const auto edited = edits.effects.find(instance.effect); edited != edits.effects.end()) {
      effects.insert(*edited);
    } else {
      const auto [read, added] = from_library_.try_emplace(instance.effect);
      if (added) read->second = library_.effect(instance.effect);
      effects.insert(*read);
    }
  }
  return effects;
}

void Stage::revise(const SceneEdits& edits) {
  std::map<std::string, Effect> effects = effects_with(edits);
  if (auto mistakes = check_references(as_played(scene_, edits), library_, effects); !mistakes.empty())
    throw FileErrors(std::move(mistakes));
  call_effects(std::move(effects), edits, call_of_);
}

void Stage::revise(Scene scene, const SceneEdits& edits) {
  const auto was = calls_by_name(scene.instances);
  std::swap(scene_, scene);
  try {
    std::map<std::string, Effect> effects = effects_with(edits);
    if (auto mistakes = check_references(as_played(scene_, edits), library_, effects); !mistakes.empty())
      throw FileErrors(std::move(mistakes));
    call_effects(std::move(effects), edits, was);
  } catch (...) {
    std::swap(scene_, scene);
    throw;
  }
}

namespace {

/// Whether their particles move the same way; effects may have been edited since.
bool moves_alike(const Instance& a, const Instance& b) {
  const auto keys = [](const Instance& i) { return i.path ? i.path->keys() : std::vector<Path::Key>{}; };
  return a.effect == b.effect && a.call_tick == b.call_tick && a.stop_tick == b.stop_tick &&
         std::ranges::equal(
             a.freezes, b.freezes,
             [](const Freeze& f, const Freeze& g) { return f.from == g.from && f.until == g.until; }) &&
         a.position == b.position && a.yaw_deg == b.yaw_deg && a.seed == b.seed &&
         std::ranges::equal(keys(a), keys(b), [](const Path::Key& k, const Path::Key& l) {
           return k.tick == l.tick && k.position == l.position;
         });
}

}  // namespace

/// For each of `others`, the call that has its particles; nothing where there is none.
std::vector<std::optional<uint32_t>> Stage::calls_by_name(const std::vector<Instance>& others) const {
  std::vector<std::optional<uint32_t>> calls;
  for (const Instance& other : others) {
    const auto same = std::ranges::find(scene_.instances, other.name, &Instance::name);
    const bool stays = same != scene_.instances.end() && moves_alike(*same, other);
    calls.push_back(stays ? call_of_[size_t(same - scene_.instances.begin())] : std::nullopt);
  }
  return calls;
}

/// What stands is replaced only once all that comes is made. `was`: the calls of the simulation there is that
/// instances of the scene were.
void Stage::call_effects(std::map<std::string, Effect> effects, const SceneEdits& edits,
                         const std::vector<std::optional<uint32_t>>& was) {
  Scene played = as_played(scene_, edits);
  std::vector<Call> calls;
  std::vector<std::optional<uint32_t>> call_of(played.instances.size()), adopted;
  for (size_t i = 0; i < played.instances.size(); ++i) {
    const Instance& instance = played.instances[i];
    if (!instance.call_tick) continue;
    std::vector<Layer> layers;
    for (const LayerOffset& layer : instance.layers) layers.push_back({layer.layer, layer.camera_offset_m});
    call_of[i] = uint32_t(calls.size());
    adopted.push_back(i < was.size() ? was[i] : std::nullopt);
    calls.push_back({.name = instance.name,
                     .effect = &effects.at(instance.effect),
                     .tick = *instance.call_tick,
                     .stop_tick = instance.stop_tick,
                     .freezes = instance.freezes,
                     .position = instance.position,
                     .path = instance.path,
                     .yaw_deg = instance.yaw_deg,
                     .seed = instance.seed,
                     .draw_order = instance.draw_order,
                     .layers = std::move(layers)});
  }
  std::map<uint32_t, glm::vec3> glowing;
  for (const Call& call : calls)
    if (std::ranges::any_of(call.effect->emitters, [](const Emitter& e) { return glows(e.look); }))
      glowing[uint32_t(&call - calls.data())] = call.position;
  auto lighting = std::make_unique<Lighting>(device_,
                                             LightingOptions{.self_shadow = scene_.light.self_shadow,
                                                             .cells = scene_.light.shadow_cells,
                                                             .fire_gain = scene_.light.fire_light},
                                             glowing);
  auto simulation = std::make_unique<Simulation>(device_, pipelines_, std::move(calls), scene_.seed,
                                                 scene_.wind, scene_.solids, scene_.light.sun_direction);
  if (simulation_) simulation->adopt(*simulation_, adopted);
  simulation_ = std::move(simulation);
  lighting_ = std::move(lighting);
  effects_ = std::move(effects);  // which keeps their addresses
  call_of_ = std::move(call_of);
  played_ = std::move(played);
}

void Stage::fit_cards(uint32_t count) {
  if (!cards_ || count > capacity_) {
    capacity_ = std::max(count + count / 4, 64u);
    cards_ = gpu::Buffer(
        device_, {.owner = "scene", .label = "cards", .bytes = uint64_t(capacity_) * sizeof(shared::Card)});
    in_order_ = false;
  }
  transparents_ = {.cards = &cards_, .puffs = &puffs_, .view = &view_, .count = count};
  // As they lie in the buffer: panes, the simulation's three sources, panes. Panes emit no haze.
  const auto [scalar, haze, rgb] = cards_by_source(simulation_->instances());
  transparents_.counts = {uint32_t(scalar_panes_.size()) + scalar, haze, rgb + uint32_t(rgb_panes_.size())};
  transparents_.groups = card_groups();
  seen_.fit(transparents_);
}

std::vector<CardGroup> Stage::card_groups() const {
  const shared::ViewData& view = view_.mapped<shared::ViewData>()[0];
  const auto depth_of = [&](glm::vec3 place) { return glm::dot(place - view.camera, view.forward); };
  std::vector<CardGroup> groups;
  uint32_t scalar = 0, rgb = uint32_t(scalar_panes_.size()) + simulation_->cards();
  for (const Pane& pane : scene_.panes)
    groups.push_back({.first = source_of(pane.transmission) == Source::kRgb ? rgb++ : scalar++,
                      .count = 1,
                      .depth = depth_of(pane.position),
                      .draw_order = pane.draw_order});
  for (const auto& emitter : cards_by_emitter(simulation_->instances()))
    groups.push_back({.first = uint32_t(scalar_panes_.size()) + emitter.first,
                      .count = emitter.count,
                      .depth = depth_of(emitter.origin),
                      .draw_order = emitter.draw_order});
  return groups;
}

void Stage::set_draw_order(const std::vector<uint32_t>& order) {
  std::vector<uint32_t> by_source;
  for (const Source source : {Source::kScalar, Source::kHaze, Source::kRgb})
    for (const uint32_t card : order)
      if (card - transparents_.first(source) < transparents_.number(source)) by_source.push_back(card);
  submission_ = gpu::make_buffer(device_, "scene", "submission", by_source);
  in_order_ = false;
}

std::vector<gpu::PassTime> Stage::go_to(uint32_t tick, glm::uvec2 size, std::optional<CameraKey> camera) {
  if (!puffs_) puffs_ = make_puff_textures(device_, pipelines_, kTextureSeed);
  // A camera of one's own has no motion of its own: it is where it is for as long as one looks.
  const std::optional<CameraKey> previous =
      camera ? std::nullopt : std::optional(camera_at(scene_.camera, std::max(tick, 1u) - 1));
  view_.mapped<shared::ViewData>()[0] =
      make_view(scene_, camera.value_or(camera_at(scene_.camera, tick)), size, tick, previous);
  simulation_->watch_by({.views =
                             [this, size](uint32_t t) {
                               return std::vector{
                                   view_volume(make_view(scene_, camera_at(scene_.camera, t), size, t, {}))};
                             },
                         .still_from = scene_.camera.back().tick});
  auto times = simulation_->go_to(tick, std::vector{view_volume(view_.mapped<shared::ViewData>()[0])});
  lighting_->fit(cards_by_emitter(simulation_->instances()), simulation_->cards());
  fit_cards(uint32_t(scalar_panes_.size() + rgb_panes_.size()) + simulation_->cards());
  if (!in_order_) {
    std::vector<uint32_t> identity(capacity_);
    std::iota(identity.begin(), identity.end(), 0u);
    submission_ = gpu::make_buffer(device_, "scene", "submission", identity);
    in_order_ = true;
  }
  return times;
}

Prelude Stage::prelude() const {
  return {.geometry =
              [this](gpu::Frame& frame, const Targets& targets) {
                frame.pass("cards", [&](gpu::Pass& pass) {
                  const std::span<const shared::Card> scalar(scalar_panes_), rgb(rgb_panes_);
                  pass.update(cards_, scalar);
                  pass.update(cards_, rgb, scalar.size() + simulation_->cards());
                  pass.barrier();  // other cards of the same buffer: the validation layer cannot tell
                  simulation_->record_cards(pass, view_, cards_, uint32_t(scalar_panes_.size()),
                                            lighting_->bodies());
                });
                seen_.record(frame, transparents_, submission_);
                lighting_->record(frame, transparents_, uint32_t(scalar_panes_.size()));
                opaque_.record_depth(frame, targets, view_);
                record_debris_depth(frame, targets, simulation_->pieces(), view_, seen_.bad_buffer(),
                                    transparents_.count);
              },
          .opaque =
              [this](gpu::Frame& frame, const Targets& targets, const gpu::Image& depth) {
                opaque_.record_color(frame, targets, depth, view_, &*lighting_);
                record_debris_color(frame, targets, depth, simulation_->pieces(), view_, opaque_.solids(),
                                    *lighting_);
              }};
}

Post Stage::post() const {
  const auto bends = [](const Emitter& emitter) { return emitter.look.distortion_deg > 0.0f; };
  const auto is_haze = [&](const Effect& effect) { return std::ranges::any_of(effect.emitters, bends); };
  Post post{.distortion = plays(is_haze), .lens = {}};
  if (const auto& wanted = scene_.depth_of_field)
    post.lens = Lens{.focus_m = wanted->focus_m, .aperture_mm = wanted->aperture_mm};
  return post;
}

bool Stage::remembers() const {
  return plays([](const Effect& effect) { return effect.off_screen == OffScreen::kPause; });
}

bool Stage::plays(const std::function<bool(const Effect&)>& which) const {
  return std::ranges::any_of(played_.instances, [&](const Instance& instance) {
    return instance.call_tick && which(effects_.at(instance.effect));
  });
}

std::vector<InstanceDemand> Stage::demand() const {
  const auto called = simulation_->demand();
  std::vector<InstanceDemand> result;
  for (size_t i = 0; i < scene_.instances.size(); ++i) {
    if (call_of_[i])
      result.push_back(called[*call_of_[i]]);
    else
      result.push_back(
          {.name = scene_.instances[i].name, .why = scene_.instances[i].call_tick ? "muted" : "not called"});
  }
  return result;
}

}  // namespace plume
