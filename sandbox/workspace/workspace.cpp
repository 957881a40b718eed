#include "sandbox/workspace/workspace.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "renderer/methods/methods.h"
#include "sandbox/measure/picture.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/view.h"
#include "sandbox/workspace/surface_point.h"

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
    : documents(library),
      a(side_of(kFirstMethod, "")),
      b(side_of(kSecondMethod, " (B)")),
      playback(playing),
      device_(device),
      pipelines_(pipelines),
      library_(library),
      stage_(std::make_unique<Stage>(device, pipelines, library, std::move(scene))) {
  open_documents();
}

/// So that their files are watched.
void Workspace::open_documents() {
  for (const Instance& instance : scene().instances)
    if (instance.call_tick) documents.open(instance.effect);
}

SceneEdits Workspace::edits() const {
  return {.effects = documents.edited(),
          .muted = switches.silent(scene().instances.size()),
          .frozen = switches.frozen};
}

void Workspace::apply_edits() {
  const Applied wanted = wanted_edits();
  if (wanted == applied_) return;
  applied_ = wanted;
  ++scene_version_;
  try {
    stage_->revise(edits());
    refused_edits_.clear();
  } catch (const FileErrors& mistakes) {
    refused_edits_ = mistakes.what();
  }
}

void Workspace::open_scene(const std::string& id) {
  Scene scene = library_.scene(id);
  if (auto unknown = check_references(scene, library_); !unknown.empty())
    throw FileErrors(std::move(unknown));
  const Playback from(scene.default_tick, scene.duration_ticks, playback.playing());
  stage_ = std::make_unique<Stage>(device_, pipelines_, library_, std::move(scene),
                                   SceneEdits{.effects = documents.edited()});
  ++scene_version_;
  switches = {};
  applied_ = wanted_edits();
  refused_edits_.clear();
  open_documents();
  playback = from;
  camera_.reset();
  for (Side* side : {&a, &b}) side->timings.clear();
  change();
}

void Workspace::change_scene(const std::function<void(Scene&)>& how) {
  Scene scene = stage_->scene();
  how(scene);
  stage_ = std::make_unique<Stage>(device_, pipelines_, library_, std::move(scene), edits());
  ++scene_version_;
  applied_ = wanted_edits();
  open_documents();
  change();
}

bool Workspace::drop_effect(const std::string& effect, Side& side, glm::vec2 place) {
  if (!side.targets) return false;
  const auto view = make_view(scene(), camera(), side.targets->size, playback.tick());
  const auto surface = surface_at(device_, *side.targets, view, place);
  if (!surface) return false;
  stage_->add_instance({.name = unused_name(scene(), effect),
                        .effect = effect,
                        .call_tick = playback.tick(),
                        .position = *surface,
                        .seed = uint32_t(scene().instances.size())},
                       edits());
  ++scene_version_;
  applied_ = wanted_edits();
  open_documents();
  change();
  return true;
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
  outdated_ |= wanted_edits() != applied_;
  outdated_ |= playback.advance(now_s);
  return outdated_ || always_draw;
}

void Workspace::draw(glm::uvec2 area) {
  const auto start = std::chrono::steady_clock::now();
  apply_edits();
  const glm::uvec2 size = resolution.picture_size(area);
  const CameraKey eye = camera();
  const PictureKey key{.scene = scene_version_,
                       .tick = playback.tick(),
                       .position = eye.position,
                       .target = eye.target,
                       .fov = eye.vertical_fov_deg,
                       .size = size};
  if (key != key_) accuracy_.clear();
  key_ = key;
  if (outdated_ || !shown() || shown()->size != size) ++picture_;
  const auto simulation = stage_->go_to(playback.tick(), size, camera_);
  for (Side* side : {&a, &b})
    if (shows(*side)) draw_side(*side, size, simulation);
  outdated_ = false;
  frame_ms_ = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

bool Workspace::measure_accuracy() {
  bool measured = false;
  for (Side* side : {&a, &b}) {
    if (outdated_ || !shows(*side) || !side->targets || side->view.shown || accuracy_.has(side->method()))
      continue;
    measured = true;
    const DrawnPicture picture = read_picture(device_, *side->targets);
    if (!accuracy_.has_reference()) {
      MethodInstance reference{.method = make_method("reference"), .owner = "ground truth", .resources = {}};
      render_frame(device_, pipelines_, *side->targets, stage_->prelude(), stage_->transparents(), reference);
      accuracy_.set_reference(read_picture(device_, *side->targets));
      outdated_ = true;  // the side's images hold the reference now
    }
    accuracy_.add(side->method(), picture, side->report.transparency_ms);
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
