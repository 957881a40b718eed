#include "sandbox/workspace/recorder.h"

#include <fmt/format.h>

#include <algorithm>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/write_replay.h"
#include "sandbox/presets/write_scene.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

bool is_same(const std::optional<CameraKey>& a, const std::optional<CameraKey>& b) {
  if (!a || !b) return !a && !b;
  return a->position == b->position && a->target == b->target && a->vertical_fov_deg == b->vertical_fov_deg;
}

void write_text(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path());
  write_file(file, text);
}

}  // namespace

void Recorder::start(Workspace& workspace) {
  discard();
  if (workspace.stage().remembers()) workspace.change_scene([](Scene&) {});
  recording_ = true;
}

void Recorder::discard() {
  *this = Recorder();
}

size_t Recorder::state_of(const Workspace& workspace) {
  const Stage& stage = workspace.stage();
  State now{.scene = stage.played(), .text = scene_text(stage.played()), .effects = {}};
  if (stage.remembers()) now.beginning = workspace.scene_version();
  for (const auto& [name, effect] : stage.effects()) now.effects[name] = effect.text;
  const auto same = std::ranges::find_if(states_, [&](const State& state) {
    return state.scene.id == now.scene.id && state.text == now.text && state.effects == now.effects &&
           state.beginning == now.beginning;
  });
  if (same != states_.end()) return size_t(same - states_.begin());
  states_.push_back(std::move(now));
  return states_.size() - 1;
}

size_t Recorder::method_of(MethodInstance& instance) {
  MethodRun now{.id = std::string(instance.method->id()), .settings = parameter_texts(*instance.method)};
  const auto same = std::ranges::find_if(replay_.methods, [&](const MethodRun& run) {
    return run.id == now.id && run.settings == now.settings;
  });
  if (same != replay_.methods.end()) return size_t(same - replay_.methods.begin());
  replay_.methods.push_back(std::move(now));
  return replay_.methods.size() - 1;
}

void Recorder::note(Workspace& workspace) {
  if (!recording_) return;
  const size_t state = state_of(workspace);
  std::vector<Shot> seen;
  for (Side* side : {&workspace.a, &workspace.b}) {
    if (!workspace.shows(*side) || !side->targets) continue;
    Shot shot;
    shot.tick = workspace.playback.tick();
    shot.method = method_of(side->method());
    shot.size = side->targets->size;
    if (workspace.has_own_camera()) shot.camera = workspace.camera();
    shot.view = side->view.choice();
    seen.push_back(std::move(shot));
    if (seen.back().camera) seen.back().camera->tick = 0;
  }
  const size_t before = replay_.shots.size();
  const auto repeats = [&](size_t i) {
    const Shot &now = seen[i], &then = replay_.shots[before - seen.size() + i];
    return state_of_shot_[before - seen.size() + i] == state && now.tick == then.tick &&
           now.method == then.method && now.size == then.size && is_same(now.camera, then.camera) &&
           now.view == then.view;
  };
  bool is_new = before < seen.size();
  for (size_t i = 0; i < seen.size() && !is_new; ++i) is_new = !repeats(i);
  if (!is_new) return;
  replay_.shots.insert(replay_.shots.end(), seen.begin(), seen.end());
  state_of_shot_.resize(replay_.shots.size(), state);
}

bool Recorder::library_has(const State& state, const PresetLibrary& library) try {
  const Scene scene = library.scene(state.scene.id);
  return scene_text(scene) == state.text && std::ranges::all_of(state.effects, [&](const auto& effect) {
           return library.effect(effect.first).text == effect.second;
         });
} catch (const PresetError&) {
  return false;
} catch (const FileErrors&) {
  return false;
}

void Recorder::save(const fs::path& file, const PresetLibrary& library) {
  if (replay_.shots.empty()) throw std::runtime_error("nothing was drawn while recording");
  fs::path folder = file;
  const bool is_ours = !fs::exists(folder.replace_extension());
  try {
    write(file, folder, library);
  } catch (...) {  // a part of a recording is none
    std::error_code gone;
    if (is_ours) fs::remove_all(folder, gone);
    throw;
  }
  discard();
}

void Recorder::write(const fs::path& file, const fs::path& folder, const PresetLibrary& library) const {
  Replay replay = replay_;
  std::vector<std::string> names;
  for (size_t i = 0; i < states_.size(); ++i) {
    // A replay begins a scene anew where the name is another.
    const bool is_first = std::ranges::find(names, states_[i].scene.id) == names.end();
    if (is_first && library_has(states_[i], library)) {
      names.push_back(states_[i].scene.id);
      continue;
    }
    // An effect keeps the name of its file, which its random numbers begin from.
    Scene scene = states_[i].scene;
    for (Instance& instance : scene.instances) {
      const auto effect = states_[i].effects.find(instance.effect);
      if (effect == states_[i].effects.end()) continue;
      const fs::path place = fs::path("effects") / std::to_string(i + 1) /
                             fs::path(instance.effect).filename().replace_extension(".toml");
      write_text(folder / place, effect->second);
      instance.effect = place.string();
    }
    names.push_back((fs::path("scenes") / std::to_string(i + 1) / (scene.id + ".toml")).string());
    write_text(folder / names.back(), scene_text(scene));
  }
  replay.name = file.stem().string();
  replay.frames = 1;
  replay.warmup = 0;
  replay.capture.error_maps = false;
  replay.scene = names[state_of_shot_.front()];
  replay.size = replay.shots.front().size;
  for (size_t i = 0; i < replay.shots.size(); ++i) {
    Shot& shot = replay.shots[i];
    if (names[state_of_shot_[i]] != replay.scene) shot.scene = names[state_of_shot_[i]];
    if (shot.size == replay.size) shot.size = glm::uvec2(0);
  }
  const std::string text = replay_text(replay);
  const Replay read = read_replay_text(text, file.string());  // before it is trusted to be one
  write_text(file, text);
}

}  // namespace plume
