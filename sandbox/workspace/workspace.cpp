#include "sandbox/workspace/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "renderer/gpu/errors.h"
#include "renderer/methods/methods.h"
#include "sandbox/measure/picture.h"
#include "sandbox/presets/add_instance.h"
#include "sandbox/presets/write_scene.h"
#include "sandbox/scene/view.h"
#include "sandbox/workspace/key_edits.h"

namespace plume {
namespace {

constexpr std::string_view kFirstMethod = "avboit", kSecondMethod = "sorted";

/// `mark` tells the memory of two sides apart.
Side side_of(std::string_view first, const std::string& mark) {
  Side side;
  for (const std::string& id : method_ids())
    side.methods.push_back({.method = make_method(id), .owner = id + mark, .resources = {}});
  const auto found = std::ranges::find(side.methods, std::string(first) + mark, &MethodInstance::owner);
  if (found != side.methods.end()) side.current = size_t(found - side.methods.begin());
  return side;
}

/// All but instances and names.
bool stands_alike(Scene a, Scene b) {
  for (Scene* scene : {&a, &b}) {
    scene->instances.clear();
    scene->name = scene->description = "";
  }
  return scene_text(a) == scene_text(b);
}

/// `name`, or with the first number from 2 that no instance has.
std::string unused_name(const Scene& scene, std::string_view name) {
  std::string candidate(name);
  for (int number = 2;
       std::ranges::find(scene.instances, candidate, &Instance::name) != scene.instances.end(); ++number)
    candidate = fmt::format("{} {}", name, number);
  return candidate;
}

}  // namespace

Workspace::Workspace(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
                     Scene scene, const Playback& playing)
    : documents(library, PresetKind::kEffect),
      scenes(library, PresetKind::kScene),
      a(side_of(kFirstMethod, "")),
      b(side_of(kSecondMethod, " (B)")),
      playback(playing),
      device_(device),
      pipelines_(pipelines),
      library_(library),
      stage_(std::make_unique<Stage>(device, pipelines, library, std::move(scene))) {
  open_documents();
  open_scene_document();
  if (const PresetDocument* document = scene_document())
    if (this->scene().seed != document->scene()->seed) seed_ = this->scene().seed;
  applied_ = wanted_edits();
}

/// So that their files are watched.
void Workspace::open_documents() {
  for (const Instance& instance : scene().instances)
    if (instance.call_tick) documents.open(instance.effect);
}

/// Of the scene that is shown, if that was read from a file which is still there without mistakes.
void Workspace::open_scene_document() {
  scene_file_.clear();
  seed_.reset();
  shown_scene_ = 0;
  const std::string file = scene().file;
  std::error_code unreadable;
  if (file.empty() || !std::filesystem::exists(file, unreadable)) return;
  const PresetDocument& document = scenes.open(file);
  if (!document.scene()) return;
  scene_file_ = file;
  shown_scene_ = document.revision();
}

PresetDocument* Workspace::scene_document() {
  return scene_file_.empty() ? nullptr : &scenes.open(scene_file_);
}

Workspace::Applied Workspace::wanted_edits() {
  const PresetDocument* document = scene_document();
  return {documents.revision(), document ? document->revision() : 0, switches};
}

SceneEdits Workspace::edits_with(const InstanceSwitches& wanted, size_t instances) const {
  return {.effects = documents.edited_effects(), .muted = wanted.silent(instances), .frozen = wanted.frozen};
}

void Workspace::take_edits() {
  const Applied wanted = wanted_edits();
  if (wanted == applied_) return;
  ++scene_version_;
  try {
    if (wanted.scene != shown_scene_)
      show_scene(*scene_document()->scene());
    else
      stage_->revise(edits_with(switches, scene().instances.size()));
    shown_scene_ = wanted.scene;
    refused_edits_.clear();
  } catch (const FileErrors& mistakes) {
    refused_edits_ = mistakes.what();
  } catch (const PresetError& missing) {
    refused_edits_ = missing.what();
  }
  applied_ = wanted_edits();  // whose switches may be renumbered
}

/// In the place of the one before, of which what stays is kept.
void Workspace::show_scene(Scene next) {
  if (seed_) next.seed = *seed_;
  std::vector<std::optional<size_t>> now;
  for (const Instance& instance : scene().instances) {
    const auto same = std::ranges::find(next.instances, instance.name, &Instance::name);
    now.push_back(same == next.instances.end() ? std::nullopt
                                               : std::optional(size_t(same - next.instances.begin())));
  }
  const InstanceSwitches kept = switches.renumbered(now);
  const SceneEdits edits = edits_with(kept, next.instances.size());
  const uint32_t last_tick = next.duration_ticks;
  if (stands_alike(next, scene()))
    stage_->revise(std::move(next), edits);
  else
    stage_ = std::make_unique<Stage>(device_, pipelines_, library_, std::move(next), edits);
  switches = kept;
  playback.set_last_tick(last_tick);
  open_documents();
}

void Workspace::open_scene(const std::string& id) {
  const std::string file = library_.find(PresetKind::kScene, id).string();
  const PresetDocument& document = scenes.open(file);
  scenes.look_at(file);
  if (!document.scene() || !document.diagnostics().empty()) throw FileErrors(document.diagnostics());
  Scene scene = *document.scene();
  Playback from(scene.default_tick, scene.duration_ticks, playback.playing());
  from.speed = playback.speed;
  from.loops = playback.loops;
  stage_ = std::make_unique<Stage>(device_, pipelines_, library_, std::move(scene),
                                   SceneEdits{.effects = documents.edited_effects()});
  ++scene_version_;
  switches = {};
  open_documents();
  open_scene_document();
  applied_ = wanted_edits();
  refused_edits_.clear();
  playback = from;
  camera_.reset();
  for (Side* side : {&a, &b}) side->timings.clear();
  change();
}

void Workspace::change_scene(const std::function<void(Scene&)>& how) {
  Scene scene = stage_->scene();
  how(scene);
  const SceneEdits edits = edits_with(switches, scene.instances.size());
  stage_ = std::make_unique<Stage>(device_, pipelines_, library_, std::move(scene), edits);
  ++scene_version_;
  applied_ = wanted_edits();
  open_documents();
  change();
}

shared::ViewData Workspace::drawn_view() const {
  const CameraKey eye{.position = key_.position, .target = key_.target, .vertical_fov_deg = key_.fov};
  return make_view(scene(), eye, key_.size, key_.tick);
}

std::optional<SurfacePoint> Workspace::surface_at(glm::vec2 place) {
  if (!shown()) return {};
  if (!surface_ || surface_of_ != picture_) surface_.emplace(device_, *shown(), drawn_view());
  surface_of_ = picture_;
  return surface_->at(place);
}

bool Workspace::drop_effect(const std::string& effect, glm::vec2 place) {
  constexpr double kGrainM = 0.001;
  library_.find(PresetKind::kEffect, effect);
  PresetDocument* document = scene_document();
  if (!document) throw std::runtime_error("the scene is of no file, so nothing can be written into it");
  const auto surface = surface_at(place);
  if (!surface) return false;
  glm::vec3 position;
  for (int axis = 0; axis < 3; ++axis)
    position[axis] = rounded(surface->position[axis], kGrainM) + 0.0f;  // no -0
  const auto outcome = add_instance(*document, {.name = unused_name(scene(), effect),
                                                .effect = effect,
                                                .call_tick = playback.tick(),
                                                .position = position,
                                                .seed = uint32_t(scene().instances.size())});
  if (!outcome.made) throw FileErrors(outcome.diagnostics);
  take_edits();
  if (!refused_edits_.empty()) {  // such as for effects that are not saved
    const std::string why = refused_edits_;
    document->undo();
    take_edits();
    throw std::runtime_error(why);
  }
  change();
  return true;
}

void Workspace::save_scene_as(const std::string& id) {
  PresetDocument* document = scene_document();
  if (!document) throw std::invalid_argument("the scene is of no file");
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  if (id.empty() || !std::ranges::all_of(id, fits))
    throw std::invalid_argument(
        fmt::format("a scene cannot be called \"{}\", expected letters, digits, _ and -", id));
  const std::filesystem::path file = library_.root() / "scenes" / (id + ".toml");
  if (std::filesystem::exists(file))
    throw std::invalid_argument(fmt::format("there is a scene `{}`, expected a new name", id));
  const bool renamed = document->set("name", id).made;
  try {
    scenes.save_as(scene_file_, file);
  } catch (...) {
    if (renamed) document->undo();
    throw;
  }
  scene_file_ = file.string();
  take_edits();
}

std::vector<PresetDocument*> Workspace::worked_on(const std::string& effect) {
  std::vector<PresetDocument*> texts;
  if (!effect.empty()) texts.push_back(&documents.open(effect));
  if (PresetDocument* scene = scene_document()) texts.push_back(scene);
  return texts;
}

PresetDocument* Workspace::to_undo(const std::string& effect) {
  PresetDocument* last = nullptr;
  for (PresetDocument* text : worked_on(effect))
    if (text->undo_order() > (last ? last->undo_order() : 0)) last = text;
  return last;
}

PresetDocument* Workspace::to_redo(const std::string& effect) {
  PresetDocument* first = nullptr;
  for (PresetDocument* text : worked_on(effect))
    if (text->redo_order() > 0 && (!first || text->redo_order() < first->redo_order())) first = text;
  return first;
}

CameraKey Workspace::camera() const {
  return camera_.value_or(camera_at(scene().camera, playback.tick()));
}

void Workspace::set_camera(const CameraKey& camera) {
  camera_ = camera;
  change();
}

void Workspace::follow_scene_camera() {
  camera_.reset();
  change();
}

void Workspace::choose_method(Side& side, size_t method) {
  if (side.current == method) return;
  side.method().resources = {};
  side.timings.clear();
  side.current = method;
  change();
}

void Workspace::compare(Comparison comparison) {
  if (comparison == comparison_) return;
  comparison_ = comparison;
  for (Side* side : {&a, &b}) {
    if (shows(*side)) continue;
    side->method().resources = {};
    side->targets.reset();
    side->timings.clear();
  }
  change();
}

bool Workspace::shows(const Side& side) const {
  return comparison_ == Comparison::kSplit || (&side == &b) == (comparison_ == Comparison::kFlip);
}

bool Workspace::advance(double now_s) {
  documents.poll(now_s);
  scenes.poll(now_s);
  outdated_ |= wanted_edits() != applied_;
  outdated_ |= playback.advance(now_s);
  return outdated_ || always_draw;
}

void Workspace::draw(glm::uvec2 area) try {
  const auto start = std::chrono::steady_clock::now();
  take_edits();
  const CameraKey eye = camera();
  if (playback.tick() != key_.tick || eye.position != key_.position || eye.target != key_.target)
    resolution.move();
  const glm::uvec2 size = resolution.picture_size(area);
  const PictureKey key{.scene = scene_version_,
                       .tick = playback.tick(),
                       .position = eye.position,
                       .target = eye.target,
                       .fov = eye.vertical_fov_deg,
                       .size = size};
  if (key != key_) {
    accuracy_.clear();
    inspector_.truth.forget();
  } else if (inspector_.truth.is_known()) {
    inspector_.truth.rest();
  }
  key_ = key;
  if (!needs_truth()) inspector_.release();
  if (outdated_ || !shown() || shown()->size != size) ++picture_;
  const auto simulation = stage_->go_to(playback.tick(), size, camera_);
  for (Side* side : {&a, &b})
    if (shows(*side)) draw_side(*side, size, simulation);
  if (comparison_ == Comparison::kSplit)
    SideView::share_scale(device_, a.view, *a.targets, b.view, *b.targets);
  bad_particles_ = plume::bad_particles(*stage_);
  outdated_ = false;
  frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
} catch (const gpu::ShaderError&) {
  stage_->start_over();  // it may have gone half of the way to the tick
  outdated_ = false;     // it is no use to try again before something changes
  throw;
}

void Workspace::reload_shaders() {
  pipelines_.reload();
  ++scene_version_;
  stage_->start_over();
  change();
}

bool Workspace::needs_truth() const {
  return compares || (shows(a) && Inspector::needs_reference(a.view.id)) ||
         (shows(b) && Inspector::needs_reference(b.view.id));
}

bool Workspace::measure_accuracy() {
  bool measured = false;
  for (Side* side : {&a, &b}) {
    if (outdated_ || !shows(*side) || !side->targets || side->view.shown || accuracy_.has(side->method()))
      continue;
    measured = true;
    const DrawnPicture picture = read_picture(device_, *side->targets);
    outdated_ |= !inspector_.truth.is_known();  // the side's images will hold the reference
    const Prelude prelude = stage_->prelude();
    const DrawnPicture& exact =
        inspector_.truth.of({device_, pipelines_, *side->targets, prelude, stage_->transparents()});
    accuracy_.add(side->method(), picture, exact, side->report.transparency_ms);
  }
  return measured;
}

void Workspace::draw_side(Side& side, glm::uvec2 size, const std::vector<gpu::PassTime>& simulation) {
  if (!side.targets || side.targets->size != size || side.targets->post != stage_->post()) {
    side.targets.emplace(device_, size, stage_->post());
    side.timings.clear();
  }
  const Prelude prelude = stage_->prelude();
  side.report = side.view.draw({device_, pipelines_, *side.targets, prelude, stage_->transparents()},
                               side.method(), inspector_);
  auto passes = simulation;
  passes.insert(passes.end(), side.report.passes.begin(), side.report.passes.end());
  side.timings.add(passes);
}

}  // namespace plume
