#include "sandbox/measure/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>

#include "renderer/methods/methods.h"
#include "sandbox/measure/build_info.h"
#include "sandbox/measure/error_map.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/flip.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/inspector.h"
#include "sandbox/measure/metrics.h"
#include "sandbox/measure/picture.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/stage.h"

namespace plume {
namespace {

using nlohmann::json;

/// A method of a replay, ready to draw, with what the repetitions of one tick gave.
struct Contender {
  MethodInstance instance;
  json settings;
  std::string label;
  std::vector<std::string> missing;   // of the device
  std::vector<std::string> left_out;  // of the last drawing
  std::vector<std::vector<gpu::PassTime>> samples;
  std::vector<double> transparency_ms;  // of the same drawings
  std::optional<DrawnPicture> picture;
  std::optional<DisplayImage> view;  // in its place
};

/// A frame before it is measured: what is known of it, and which files it will leave.
struct Job {
  FrameResult frame;
  std::string hdr;  // "" = not asked for
};

bool is_same(const FrameResult& a, const FrameResult& b) {
  return a.scene == b.scene && a.tick == b.tick && a.shot == b.shot && a.width == b.width &&
         a.height == b.height && a.method == b.method && a.settings == b.settings;
}

bool shares_file(const FrameResult& a, const FrameResult& b) {
  return (!a.image.empty() && a.image == b.image) || (!a.error_map.empty() && a.error_map == b.error_map);
}

/// The part of a file name that tells a replay's methods apart: the id, and the settings that the replay
/// names.
std::string label_of(const MethodRun& run) {
  std::string label = run.id;
  for (const auto& [name, value] : run.settings) label += fmt::format("-{}-{}", name, value);
  std::ranges::replace(label, '/', '_');  // "1/4" is a value, not a folder
  return label;
}

std::string stem_of(const std::string& scene, uint32_t tick, const std::string& label) {
  return fmt::format("{}_{:06}_{}", scene, tick, label);
}

/// Of a recording, whose pictures stand in the order in which they were seen.
std::string stem_of_shot(uint32_t shot, const std::string& scene, uint32_t tick, const std::string& method,
                         const ViewChoice& view) {
  return fmt::format("shot_{:06}_{}{}{}", shot, stem_of(scene, tick, method), view.id.empty() ? "" : "_",
                     view.id);
}

/// The scenes of a replay by the names it has for them.
using Scenes = std::map<std::string, Scene>;

const std::string& scene_name(const Replay& replay, const Shot& shot) {
  return shot.scene.empty() ? replay.scene : shot.scene;
}

/// What a replay draws at once: a tick with all of its methods, or a shot.
struct Moment {
  uint32_t tick;
  glm::uvec2 size;
  std::optional<CameraKey> camera;  // of one's own
  uint32_t shot = 0;                // from 1; 0: none
  ViewChoice view{};                // of its method, in the place of the picture
};

void refuse_shared_files(const std::vector<Replay>& replays, const std::vector<Scenes>& scenes) {
  std::set<std::string> stems;
  const auto claim = [&](const std::string& stem, const std::string& what) {
    if (!stems.insert(stem).second)
      throw std::runtime_error(fmt::format(
          "{} is asked for twice, and the second would overwrite the files of the first: run them with an "
          "--out each",
          what));
  };
  for (size_t i = 0; i < replays.size(); ++i) {
    for (const uint32_t tick : replays[i].ticks)
      for (const MethodRun& run : replays[i].methods) {
        const std::string& scene = scenes[i].at(replays[i].scene).id;
        claim(stem_of(scene, tick, label_of(run)),
              fmt::format("{} at tick {} with {}", scene, tick, label_of(run)));
      }
    for (uint32_t s = 0; s < replays[i].shots.size(); ++s) {
      const Shot& shot = replays[i].shots[s];
      const std::string& scene = scenes[i].at(scene_name(replays[i], shot)).id;
      const std::string& method = replays[i].methods[shot.method].id;
      claim(stem_of_shot(s + 1, scene, shot.tick, method, shot.view),
            fmt::format("shot {}, {} at tick {} with {}", s + 1, scene, shot.tick, method));
    }
  }
}

ErrorSummary compare(const DrawnPicture& reference, const DrawnPicture& test, Raster<float>& map) {
  const MaxError worst = max_abs(reference.linear, test.linear);
  FlipResult difference = flip(reference.display, test.display);
  map = std::move(difference.map);
  return {.rmse = rmse(reference.linear, test.linear),
          .psnr_db = psnr_db(reference.display, test.display),
          .ssim = ssim(reference.display, test.display),
          .flip = difference.mean,
          .max = worst.value,
          .max_x = worst.x,
          .max_y = worst.y};
}

void summarise_passes(const std::vector<std::vector<gpu::PassTime>>& samples, FrameResult& frame) {
  std::vector<double> totals;
  for (const auto& sample : samples) {
    double total = 0;
    for (const gpu::PassTime& pass : sample) total += pass.ms;
    totals.push_back(total);
  }
  frame.gpu_ms = summarise(totals).median;
  for (size_t p = 0; p < samples.front().size(); ++p) {
    std::vector<double> times;
    for (const auto& sample : samples) times.push_back(sample[p].ms);
    frame.passes.push_back({samples.front()[p].name, summarise(times), samples.front()[p].fragments});
  }
}

json demand_json(const Stage& stage, const gpu::Pipelines& pipelines) {
  json result = plume::demand_json(stage.demand());
  result["pipelines"] = pipelines.count();
  result["state_hash"] = fmt::format("{:016x}", stage.simulation().state_hash());
  return result;
}

class Measurement {
 public:
  Measurement(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
              const MeasurementOptions& options)
      : device_(device), pipelines_(pipelines), library_(library), options_(options) {
    std::error_code failure;
    std::filesystem::create_directories(options.out, failure);
    if (failure) throw FileError(options.out, failure.message());
    results_.environment = environment(device);
    const auto manifest = options.out / "results.json";
    if (options.resume && std::filesystem::exists(manifest)) go_on_from(manifest);
  }

  Results run(const std::vector<Replay>& replays) {
    std::vector<Scenes>
        scenes;  // all before any is drawn: a mistake in the last must not cost the work on the first
    for (const Replay& replay : replays) scenes.push_back(scenes_of(replay));
    refuse_shared_files(replays, scenes);
    for (const Replay& replay : replays) total_ += replay.ticks.size() + replay.shots.size();
    total_ = (total_ + options_.shard.count - 1 - options_.shard.index) / options_.shard.count;
    write_manifest();    // what an earlier run left here is over from now on
    size_t counted = 0;  // over all replays, so that shards share them evenly
    for (size_t i = 0; i < replays.size(); ++i) {
      run_ticks(replays[i], scenes[i], counted);
      run_shots(replays[i], scenes[i], counted);
    }
    write_manifest();
    return std::move(results_);
  }

 private:
  static json environment(const gpu::Device& device) {
    return {{"device", device.info().name}, {"driver", device.info().driver},
            {"api", device.info().api},     {"build", build_name()},
            {"commit", build_commit()},     {"threads", std::thread::hardware_concurrency()}};
  }

  /// Takes over what an earlier run measured, unless its numbers would be passed off as another device's or
  /// build's.
  void go_on_from(const std::filesystem::path& manifest) {
    Results before = read_results(manifest);
    for (const auto& [name, value] : results_.environment.items())
      if (const json other = before.environment.value(name, json()); other != value)
        throw std::runtime_error(
            fmt::format("{} was measured with {} {}, this is {}: leave out --resume or choose another --out",
                        manifest.string(), name, other.dump(), value.dump()));
    results_ = std::move(before);
  }

  Scenes scenes_of(const Replay& replay) const {
    const PresetLibrary library = library_.behind(replay.presets);
    Scenes scenes;
    const auto add = [&](const std::string& name) {
      if (scenes.contains(name)) return;
      Scene scene = library.scene(name);
      if (auto unknown = check_references(scene, library); !unknown.empty())
        throw FileErrors(std::move(unknown));
      if (replay.seed) scene.seed = *replay.seed;
      if (!replay.camera.empty()) scene.camera = replay.camera;
      scenes.emplace(name, std::move(scene));
    };
    if (!replay.ticks.empty()) add(replay.scene);
    for (const Shot& shot : replay.shots) add(scene_name(replay, shot));
    return scenes;
  }

  bool is_ours(size_t& counted) const { return counted++ % options_.shard.count == options_.shard.index; }

  void run_ticks(const Replay& replay, const Scenes& scenes, size_t& counted) {
    std::vector<uint32_t> ticks;
    for (const uint32_t tick : replay.ticks)
      if (is_ours(counted)) ticks.push_back(tick);
    if (ticks.empty()) return;

    Stage stage(device_, pipelines_, library_.behind(replay.presets), scenes.at(replay.scene));
    const Targets targets(device_, replay.size, stage.post());
    std::vector<Contender> contenders = make_contenders(replay);
    for (const uint32_t tick : ticks)
      run_moment(replay, stage, targets, contenders, {.tick = tick, .size = replay.size});
  }

  /// What one shot after another has in common stays: the scene, the images, the method's memory.
  void run_shots(const Replay& replay, const Scenes& scenes, size_t& counted) {
    if (replay.shots.empty()) return;
    std::optional<Stage> stage;
    std::optional<Targets> targets;
    const std::string* scene = nullptr;
    std::vector<Contender> contenders = make_contenders(replay);
    size_t method = 0;
    for (uint32_t i = 0; i < replay.shots.size(); ++i) {
      const Shot& shot = replay.shots[i];
      const Moment moment{.tick = shot.tick,
                          .size = shot.size == glm::uvec2(0) ? replay.size : shot.size,
                          .camera = shot.camera,
                          .shot = i + 1,
                          .view = shot.view};
      if (!scene || *scene != scene_name(replay, shot)) {
        scene = &scene_name(replay, shot);
        targets.reset();
        stage.reset();
        stage.emplace(device_, pipelines_, library_.behind(replay.presets), scenes.at(*scene));
      }
      if (!is_ours(counted)) {
        pass_by(*stage, moment);
        continue;
      }
      if (!targets || targets->size != moment.size) targets.emplace(device_, moment.size, stage->post());
      if (method != shot.method) contenders[method].instance.resources = {};
      method = shot.method;
      run_moment(replay, *stage, *targets, std::span(contenders).subspan(method, 1), moment);
    }
  }

  std::vector<Contender> make_contenders(const Replay& replay) {
    std::vector<Contender> contenders;
    for (const MethodRun& run : replay.methods) {
      Contender c;
      c.instance.method = make_method(run.id);
      for (const auto& [name, value] : run.settings) set_parameter(*c.instance.method, name, value);
      c.instance.owner = c.label = label_of(run);
      c.settings = parameter_values(*c.instance.method);
      c.missing = c.instance.method->missing(device_);
      contenders.push_back(std::move(c));
    }
    return contenders;
  }

  static Job job_of(const Replay& replay, const Stage& stage, const Contender& contender,
                    const Moment& moment) {
    Job job;
    FrameResult& frame = job.frame;
    frame.scene = stage.scene().id;
    frame.tick = moment.tick;
    frame.shot = moment.shot;
    frame.width = moment.size.x;
    frame.height = moment.size.y;
    frame.method = contender.instance.method->id();
    frame.settings = contender.settings;
    if (!contender.missing.empty()) {
      frame.status = fmt::format("unavailable: needs {}", fmt::join(contender.missing, ", "));
      return job;
    }
    const Capture& capture = replay.capture;
    if (!capture.ticks.empty() && !std::ranges::binary_search(capture.ticks, frame.tick)) return job;
    const std::string stem =
        frame.shot ? stem_of_shot(frame.shot, frame.scene, frame.tick, frame.method, moment.view)
                   : stem_of(frame.scene, frame.tick, contender.label);
    if (capture.images) frame.image = stem + ".png";
    if (capture.error_maps) frame.error_map = stem + "_error.png";
    if (capture.hdr) job.hdr = stem + ".exr";
    return job;
  }

  std::vector<FrameResult>::iterator first_unplaced() {
    return results_.frames.begin() + std::ptrdiff_t(placed_);
  }

  /// What an earlier run left of the job; the end when not all of it is there.
  std::vector<FrameResult>::iterator finished(const Job& job) {
    for (const std::string& file : {job.frame.image, job.frame.error_map, job.hdr})
      if (!file.empty() && !std::filesystem::exists(options_.out / file)) return results_.frames.end();
    return std::find_if(first_unplaced(), results_.frames.end(), [&](const FrameResult& f) {
      return is_same(f, job.frame) && f.image == job.frame.image && f.error_map == job.frame.error_map;
    });
  }

  void run_moment(const Replay& replay, Stage& stage, const Targets& targets, std::span<Contender> contenders,
                  const Moment& moment) {
    std::vector<Job> jobs;
    for (const Contender& c : contenders) jobs.push_back(job_of(replay, stage, c, moment));
    const bool all_done =
        std::ranges::all_of(jobs, [&](const Job& job) { return finished(job) != results_.frames.end(); });
    if (all_done) {
      pass_by(stage, moment);
      for (const Job& job : jobs) place(finished(job));
    } else {
      stop_if_interrupted();
      stage.go_to(moment.tick, moment.size, moment.camera);
      const DrawnPicture reference = draw_reference(stage, targets);
      for (Contender& c : contenders)
        c.samples.clear(), c.transparency_ms.clear(), c.picture.reset(), c.view.reset();
      draw_contenders(replay, stage, targets, contenders);
      if (!moment.view.id.empty()) look_at(moment.view, stage, targets, contenders.front());
      for (size_t i = 0; i < jobs.size(); ++i)
        if (const auto before = finished(jobs[i]); before != results_.frames.end())
          place(before);
        else
          record(std::move(jobs[i]), contenders[i], reference);
      results_.demand = demand_json(stage, pipelines_);
      write_manifest();
    }
    ++done_;
    if (options_.progress)
      options_.progress(done_, total_, fmt::format("{} tick {}", stage.scene().id, moment.tick));
  }

  /// A shot that is not drawn here still is part of what those after it remember.
  static void pass_by(Stage& stage, const Moment& moment) {
    if (moment.shot && stage.remembers()) stage.go_to(moment.tick, moment.size, moment.camera);
  }

  DrawnPicture draw_reference(const Stage& stage, const Targets& targets) {
    if (!reference_.method)
      reference_ = {.method = make_method("reference"), .owner = "ground truth", .resources = {}};
    render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), reference_);
    return read_picture(device_, targets);
  }

  /// Repetitions of all methods in turn, so that a drift of the machine's speed meets them alike.
  void draw_contenders(const Replay& replay, const Stage& stage, const Targets& targets,
                       std::span<Contender> contenders) {
    for (uint32_t repetition = 0; repetition < replay.warmup + replay.frames; ++repetition)
      for (Contender& c : contenders) {
        if (!c.missing.empty()) continue;
        stop_if_interrupted();
        auto report =
            render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), c.instance);
        c.left_out = std::move(report.left_out);
        if (repetition >= replay.warmup) {
          c.samples.push_back(std::move(report.passes));
          c.transparency_ms.push_back(report.transparency_ms);
        }
        if (!c.picture) c.picture = read_picture(device_, targets);
      }
  }

  /// Times and errors stay those of the picture.
  void look_at(const ViewChoice& choice, const Stage& stage, const Targets& targets, Contender& c) {
    const auto view = Inspector::find(*c.instance.method, choice.id);
    if (!view || !c.missing.empty()) return;  // --set may have taken the view away
    const Prelude prelude = stage.prelude();
    const Inspected seen =
        inspector_.inspect({device_, pipelines_, targets, prelude, stage.transparents()}, c.instance, *view,
                           std::min(choice.slice, std::max(view->slices, 1u) - 1));
    c.view = image_of(seen, scale_of(choice, *view, range_of(seen.values)));
  }

  void stop_if_interrupted() const {
    if (options_.interrupted && options_.interrupted()) throw Interrupted();
  }

  /// Measures and writes the files; replaces what earlier runs said of the same frame or the same files.
  void record(Job job, const Contender& contender, const DrawnPicture& reference) {
    FrameResult& frame = job.frame;
    if (contender.missing.empty()) {
      summarise_passes(contender.samples, frame);
      frame.transparency_ms = summarise(contender.transparency_ms).median;
      frame.statistics = contender.instance.method->statistics(device_, contender.instance.resources);
      frame.left_out = contender.left_out;
      frame.memory_bytes = device_.memory().owner_bytes(contender.instance.owner);
      Raster<float> error_map;
      frame.error = compare(reference, *contender.picture, error_map);
      if (!frame.image.empty())
        write_png(options_.out / frame.image, contender.view.value_or(contender.picture->display));
      if (!frame.error_map.empty()) write_png(options_.out / frame.error_map, magma_image(error_map));
      if (!job.hdr.empty()) write_exr(options_.out / job.hdr, contender.picture->linear);
    }
    const auto replaced = std::remove_if(first_unplaced(), results_.frames.end(), [&](const FrameResult& f) {
      return is_same(f, frame) || shares_file(f, frame);
    });
    results_.frames.erase(replaced, results_.frames.end());
    results_.frames.push_back(std::move(frame));
    place(results_.frames.end() - 1);
  }

  /// Frames stand in the order of the jobs, and after them what earlier runs left of jobs that are still to
  /// come.
  void place(std::vector<FrameResult>::iterator frame) {
    std::rotate(first_unplaced(), frame, frame + 1);
    ++placed_;
  }

  void write_text(const char* name, const std::string& text) const {
    write_file(options_.out / name, {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  }
  void write_manifest() const {
    write_text("results.json", to_json(results_).dump(2) + "\n");
    write_text("results.csv", to_csv(results_));
  }

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  const PresetLibrary& library_;
  const MeasurementOptions& options_;
  Results results_;
  MethodInstance reference_;
  Inspector inspector_;
  size_t total_ = 0, done_ = 0;  // ticks
  size_t placed_ = 0;            // frames
};

}  // namespace

Results measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
                const std::vector<Replay>& replays, const MeasurementOptions& options) {
  return Measurement(device, pipelines, library, options).run(replays);
}

}  // namespace plume
