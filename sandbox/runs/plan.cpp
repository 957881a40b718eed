#include "sandbox/runs/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "renderer/methods/methods.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/runs/fingerprint.h"

namespace plume {
namespace {

using nlohmann::json;

/// The part of an id that tells a replay's methods apart: the method's, and the settings that the replay
/// names.
std::string label_of(const MethodRun& run) {
  std::string label = run.id;
  for (const auto& [name, value] : run.settings) label += fmt::format("-{}-{}", name, value);
  std::ranges::replace(label, '/', '_');  // "1/4" is a value, not a folder
  return label;
}

/// In which of these the replays of one script differ, so that ids must tell them apart.
struct Differences {
  bool size = false, seed = false;
};

std::string id_of(const Moment& moment, const MethodRun& run, Differences differ) {
  if (moment.shot)  // a recording, whose pictures stand in the order in which they were seen
    return fmt::format("shot_{:06}_{}_{:06}_{}{}{}", moment.shot, moment.scene, moment.tick, run.id,
                       moment.view.id.empty() ? "" : "_", moment.view.id);
  std::string id = fmt::format("{}_{:06}_{}", moment.scene, moment.tick, label_of(run));
  if (differ.size) id += fmt::format("_{}x{}", moment.size.x, moment.size.y);
  if (differ.seed) id += fmt::format("_seed{}", moment.seed);
  return id;
}

Job job_of(const Replay& replay, const Moment& moment, size_t method, Differences differ) {
  Job job{.id = id_of(moment, replay.methods[method], differ), .method = method};
  const Capture& capture = replay.capture;
  if (!is_captured(capture, moment.tick)) return job;
  if (capture.images) job.image = job.id + ".png";
  if (capture.error_maps) job.error_map = job.id + "_error.png";
  if (capture.hdr) job.hdr = job.id + ".exr";
  return job;
}

/// Scenes as files have them, each read once however many replays show it, with a fingerprint of all presets
/// that decide what it shows.
class SceneFiles {
 public:
  explicit SceneFiles(const PresetLibrary& library) : library_(library) {}

  struct Read {
    Scene scene;
    std::string fingerprint;
  };
  const Read& read(const Replay& replay, const std::string& name) {
    const auto [found, added] = read_.try_emplace({replay.presets, name});
    if (added) found->second = read(library_.behind(replay.presets), name);
    return found->second;
  }

 private:
  static Read read(const PresetLibrary& library, const std::string& name) {
    Read read{.scene = library.scene(name), .fingerprint = {}};
    if (auto unknown = check_references(read.scene, library); !unknown.empty())
      throw FileErrors(std::move(unknown));
    Fingerprint texts;
    texts.add(load_text(library.find(PresetKind::kScene, name)));
    std::set<std::string> effects;
    for (const Instance& instance : read.scene.instances)
      if (instance.call_tick) effects.insert(instance.effect);
    for (const std::string& id : effects) {
      const Effect effect = library.effect(id);
      texts.add(effect.text);
      for (const Mesh& mesh : effect.meshes) texts.add(load_text(library.find(PresetKind::kMesh, mesh.id)));
      const std::filesystem::path fields = field_folder(library.find(PresetKind::kEffect, id));
      for (const Emitter& emitter : effect.emitters)
        if (const auto& field = emitter.motion.field) texts.add(load_text(fields / (field->id + ".fga")));
    }
    read.fingerprint = texts.text();
    return read;
  }

  const PresetLibrary& library_;
  std::map<std::pair<std::string, std::string>, Read> read_;
};

json camera_json(const CameraKey& key) {
  return {key.tick,     key.position.x, key.position.y, key.position.z,
          key.target.x, key.target.y,   key.target.z,   key.vertical_fov_deg};
}

/// What a replay adds to its jobs' ids and its scenes' presets.
json decisions(const Replay& replay) {
  json camera = json::array(), methods = json::array(), pixels = json::array();
  for (const CameraKey& key : replay.camera) camera.push_back(camera_json(key));
  for (const MethodRun& run : replay.methods) methods.push_back({run.id, run.settings});
  for (const glm::uvec2 pixel : replay.capture.pixels) pixels.push_back({pixel.x, pixel.y});
  return {replay.frames, replay.warmup, camera, methods, pixels};
}

json decisions(const Moment& moment) {
  const ViewChoice& view = moment.view;
  return {moment.size.x,
          moment.size.y,
          moment.seed,
          moment.camera ? camera_json(*moment.camera) : json(nullptr),
          {view.id, view.slice, view.logarithmic,
           view.range ? json{view.range->x, view.range->y} : json(nullptr)}};
}

/// One after the other; refuses a second job of one id.
class Planner {
 public:
  Planner(const PresetLibrary& library, const std::filesystem::path& shaders) : files_(library) {
    if (!shaders.empty()) add_files(shaders);
  }

  Plan plan(std::vector<Replay> replays) {
    for (Replay& replay : replays) take(std::move(replay));
    for (size_t i = 0; i < plan_.replays.size(); ++i) add_moments(i);
    fingerprint_.add(fmt::format("{} jobs", plan_.jobs));
    plan_.id = fingerprint_.text();
    return std::move(plan_);
  }

 private:
  void add_files(const std::filesystem::path& folder) {
    std::map<std::string, std::filesystem::path> files;  // in an order of their own
    std::error_code absent;                              // is told of where they are compiled
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, absent))
      if (entry.is_regular_file()) files[entry.path().lexically_relative(folder).string()] = entry.path();
    for (const auto& [name, path] : files) {
      const std::vector<uint8_t> bytes = read_file(path);
      fingerprint_.add(name);
      fingerprint_.add({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    }
  }

  void take(Replay replay) {
    if (replay.ticks.empty() && replay.shots.empty())
      replay.ticks = {files_.read(replay, replay.scene).scene.default_tick};
    auto& [sizes, seeds] = asked_[replay.id];
    sizes.insert({replay.size.x, replay.size.y});
    seeds.insert(replay.seed);
    plan_.replays.push_back(std::move(replay));
  }

  const Scene& scene_of(size_t replay_index, const std::string& name) {
    const Replay& replay = plan_.replays[replay_index];
    auto& scenes = plan_.scenes[replay_index];
    if (const auto found = scenes.find(name); found != scenes.end()) return found->second;
    const SceneFiles::Read& file = files_.read(replay, name);
    fingerprint_.add(file.fingerprint);
    Scene& scene = scenes[name] = file.scene;
    if (replay.seed) scene.seed = *replay.seed;
    if (!replay.camera.empty()) scene.camera = replay.camera;
    return scene;
  }

  void add_moments(size_t index) {
    const Replay& replay = plan_.replays[index];
    plan_.scenes.emplace_back();
    fingerprint_.add(decisions(replay).dump());
    for (const uint32_t tick : replay.ticks) {
      const Scene& scene = scene_of(index, replay.scene);
      std::vector<size_t> methods(replay.methods.size());
      for (size_t i = 0; i < methods.size(); ++i) methods[i] = i;
      add({.replay = index,
           .scene_name = replay.scene,
           .scene = scene.id,
           .seed = scene.seed,
           .tick = tick,
           .size = replay.size},
          methods);
    }
    for (uint32_t i = 0; i < replay.shots.size(); ++i) {
      const Shot& shot = replay.shots[i];
      const std::string& name = shot.scene.empty() ? replay.scene : shot.scene;
      const Scene& scene = scene_of(index, name);
      add({.replay = index,
           .scene_name = name,
           .scene = scene.id,
           .seed = scene.seed,
           .tick = shot.tick,
           .size = shot.size == glm::uvec2(0) ? replay.size : shot.size,
           .camera = shot.camera,
           .shot = i + 1,
           .view = shot.view},
          {shot.method});
    }
  }

  void add(Moment moment, const std::vector<size_t>& methods) {
    const Replay& replay = plan_.replays[moment.replay];
    const auto& [sizes, seeds] = asked_.at(replay.id);
    const Differences differ{.size = sizes.size() > 1, .seed = seeds.size() > 1};
    moment.first_job = plan_.jobs;
    fingerprint_.add(decisions(moment).dump());
    for (const size_t method : methods) {
      Job job = job_of(replay, moment, method, differ);
      if (!ids_.insert(job.id).second) refuse(moment, replay.methods[method]);
      for (const std::string& text : {job.id, job.image, job.error_map, job.hdr}) fingerprint_.add(text);
      moment.jobs.push_back(std::move(job));
    }
    plan_.jobs += moment.jobs.size();
    plan_.moments.push_back(std::move(moment));
  }

  [[noreturn]] static void refuse(const Moment& moment, const MethodRun& run) {
    throw std::runtime_error(fmt::format(
        "{}{} at tick {} with {} is asked for twice, and the second would overwrite the files of the first: "
        "run them with an --out each",
        moment.shot ? fmt::format("shot {}, ", moment.shot) : "", moment.scene, moment.tick,
        moment.shot ? run.id : label_of(run)));
  }

  SceneFiles files_;
  Plan plan_;
  Fingerprint fingerprint_;
  std::set<std::string> ids_;
  struct Asked {
    std::set<std::pair<uint32_t, uint32_t>> sizes;
    std::set<std::optional<uint32_t>> seeds;
  };
  std::map<std::string, Asked> asked_;  // by script
};

}  // namespace

std::vector<std::string> Plan::order() const {
  std::vector<std::string> ids;
  ids.reserve(jobs);
  for (const Moment& moment : moments)
    for (const Job& job : moment.jobs) ids.push_back(job.id);
  return ids;
}

Plan make_plan(const PresetLibrary& library, std::vector<Replay> replays,
               const std::filesystem::path& shaders) {
  return Planner(library, shaders).plan(std::move(replays));
}

FrameResult planned_frame(const Plan& plan, const Moment& moment, const Job& job) {
  const MethodRun& run = plan.replays[moment.replay].methods[job.method];
  const auto method = make_method(run.id);
  for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
  FrameResult frame;
  frame.job = job.id;
  frame.scene = moment.scene;
  frame.tick = moment.tick;
  frame.shot = moment.shot;
  frame.seed = moment.seed;
  frame.width = moment.size.x;
  frame.height = moment.size.y;
  frame.method = run.id;
  frame.settings = parameter_values(*method);
  frame.image = job.image;
  frame.error_map = job.error_map;
  frame.hdr = job.hdr;
  return frame;
}

}  // namespace plume
