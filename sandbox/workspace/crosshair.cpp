#include "sandbox/workspace/crosshair.h"

#include <algorithm>
#include <cmath>

namespace plume {

void Crosshair::place(glm::ivec2 pixel, glm::uvec2 size) {
  const glm::dvec2 inside = glm::clamp(glm::dvec2(pixel), glm::dvec2(0.0), glm::dvec2(size) - 1.0);
  direction_ = (inside + 0.5 - 0.5 * glm::dvec2(size)) / double(size.y);
}

void Crosshair::move(glm::ivec2 pixels, glm::uvec2 size) {
  place(glm::ivec2(pixel(size)) + pixels, size);
}

void Crosshair::remove(Workspace& workspace) {
  for (const std::string& id : others_)
    if (MethodInstance* instance = other(workspace, id)) instance->resources = {};
  direction_.reset();
  told_.reset();
  targets_.reset();
  drawn_.clear();
  answered_ = {};
}

glm::uvec2 Crosshair::pixel(glm::uvec2 size) const {
  const glm::dvec2 at = glm::floor(*direction_ * double(size.y) + 0.5 * glm::dvec2(size));
  return glm::uvec2(glm::clamp(at, glm::dvec2(0.0), glm::dvec2(size) - 1.0));
}

void Crosshair::ask_of_others(Workspace& workspace, std::vector<std::string> ids) {
  for (const std::string& id : others_)
    if (std::ranges::find(ids, id) == ids.end()) {
      if (MethodInstance* instance = other(workspace, id)) instance->resources = {};
      drawn_.erase(id);
    }
  others_ = std::move(ids);
  others_changed_ = true;
}

/// Nothing: it is shown anyway.
MethodInstance* Crosshair::other(Workspace& workspace, const std::string& id) const {
  const auto found = std::ranges::find(workspace.a.methods, id,
                                       [](const MethodInstance& m) { return std::string(m.method->id()); });
  if (found == workspace.a.methods.end()) return nullptr;
  if (workspace.shows(workspace.a) && &*found == &workspace.a.method()) return nullptr;
  return &*found;
}

std::optional<Crosshair::Question> Crosshair::question(const Workspace& workspace) const {
  if (!placed() || !workspace.shown()) return std::nullopt;
  const glm::uvec2 size = workspace.shown()->size;
  return Question{.picture = workspace.picture(), .pixel = pixel(size), .size = size};
}

void Crosshair::update(Workspace& workspace, double now_s) {
  if (workspace.picture() != seen_picture_) {
    seen_picture_ = workspace.picture();
    picture_since_s_ = now_s;
  }
  const auto asked = question(workspace);
  if (!asked || workspace.is_outdated()) return;
  const bool still = now_s - picture_since_s_ >= kStillSeconds && !workspace.playback.playing();
  bool due = others_changed_ || asked->pixel != answered_.pixel || asked->size != answered_.size;
  if (asked->picture != answered_.picture) due = now_s - answered_s_ >= 1.0 / kAnswersPerSecond;
  if (still) due |= draw_others(workspace);
  if (!due) return;
  ask(workspace, *asked);
  answered_s_ = now_s;
}

/// Those that were drawn for another picture; true when there were any.
bool Crosshair::draw_others(Workspace& workspace) {
  bool drew = false;
  for (const std::string& id : others_) {
    MethodInstance* instance = other(workspace, id);
    if (!instance || drawn_[id] == workspace.picture()) continue;
    drawn_[id] = workspace.picture();
    drew = true;
    if (!instance->method->missing(workspace.device()).empty()) continue;
    const Stage& stage = workspace.stage();
    if (!targets_ || targets_->size != workspace.shown()->size)
      targets_.emplace(workspace.device(), workspace.shown()->size);
    render_frame(workspace.device(), workspace.pipelines(), *targets_, stage.prelude(), stage.transparents(),
                 *instance);
  }
  return drew;
}

void Crosshair::ask(Workspace& workspace, const Question& question) {
  gpu::Device& device = workspace.device();
  gpu::Pipelines& pipelines = workspace.pipelines();
  const Stage& stage = workspace.stage();
  PixelProbe probe = probe_pixel(device, pipelines, stage, *workspace.shown(), question.pixel);
  for (Side* side : {&workspace.a, &workspace.b})
    if (workspace.shows(*side))
      probe.methods.push_back(probe_method(device, pipelines, stage, *side->targets, side->method(), probe));
  for (const std::string& id : others_) {
    const MethodInstance* instance = other(workspace, id);
    const auto drawn = drawn_.find(id);
    if (!instance || drawn == drawn_.end() || drawn->second != question.picture) continue;
    probe.methods.push_back(instance->method->missing(device).empty()
                                ? probe_method(device, pipelines, stage, *targets_, *instance, probe)
                                : unavailable_at_pixel(device, *instance));
  }
  told_ = std::move(probe);
  answered_ = question;
  others_changed_ = false;
}

std::string Crosshair::stale_because(const Workspace& workspace) const {
  const auto asked = question(workspace);
  if (!asked) return "";
  if (!told_) return "not asked yet";
  if (asked->pixel != answered_.pixel || asked->size != answered_.size) return "of another pixel";
  if (asked->picture != answered_.picture || workspace.is_outdated()) return "of an earlier picture";
  return "";
}

std::vector<std::string> Crosshair::waiting(Workspace& workspace) const {
  std::vector<std::string> ids;
  for (const std::string& id : others_) {
    if (!other(workspace, id)) continue;
    const auto drawn = drawn_.find(id);
    if (drawn == drawn_.end() || drawn->second != answered_.picture) ids.push_back(id);
  }
  return ids;
}

}  // namespace plume
