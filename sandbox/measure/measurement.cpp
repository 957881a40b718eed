#include "sandbox/measure/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <thread>

#include "renderer/methods/methods.h"
#include "sandbox/measure/build_info.h"
#include "sandbox/measure/error_map.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/flip.h"
#include "sandbox/measure/image_io.h"
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
};

/// A frame before it is measured: what is known of it, and which files it will leave.
struct Job {
  FrameResult frame;
  std::string hdr;  // "" = not asked for
};

bool is_same(const FrameResult& a, const FrameResult& b) {
  return a.scene == b.scene && a.tick == b.tick && a.width == b.width && a.height == b.height &&
         a.method == b.method && a.settings == b.settings;
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

void refuse_shared_files(const std::vector<Replay>& replays, const std::vector<Scene>& scenes) {
  std::set<std::string> stems;
  for (size_t i = 0; i < replays.size(); ++i)
    for (const uint32_t tick : replays[i].ticks)
      for (const MethodRun& run : replays[i].methods)
        if (!stems.insert(stem_of(scenes[i].id, tick, label_of(run))).second)
          throw std::runtime_error(
              fmt::format("{} at tick {} with {} is asked for twice, and the second would overwrite the "
                          "files of the first: run them with an --out each",
                          scenes[i].id, tick, label_of(run)));
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
    std::vector<Scene>
        scenes;  // all before any is drawn: a mistake in the last must not cost the work on the first
    for (const Replay& replay : replays) scenes.push_back(scene_of(replay));
    refuse_shared_files(replays, scenes);
    for (const Replay& replay : replays) total_ += replay.ticks.size();
    total_ = (total_ + options_.shard.count - 1 - options_.shard.index) / options_.shard.count;
    write_manifest();  // what an earlier run left here is over from now on
    size_t ticks = 0;
    for (size_t i = 0; i < replays.size(); ++i) run_replay(replays[i], std::move(scenes[i]), ticks);
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

  Scene scene_of(const Replay& replay) const {
    Scene scene = library_.scene(replay.scene);
    if (auto unknown = check_references(scene, library_); !unknown.empty())
      throw FileErrors(std::move(unknown));
    if (replay.seed) scene.seed = *replay.seed;
    if (!replay.camera.empty()) scene.camera = replay.camera;
    return scene;
  }

  /// `counted` goes over the ticks of all replays, so that shards share them evenly.
  void run_replay(const Replay& replay, Scene scene, size_t& counted) {
    std::vector<uint32_t> ticks;
    for (const uint32_t tick : replay.ticks)
      if (counted++ % options_.shard.count == options_.shard.index) ticks.push_back(tick);
    if (ticks.empty()) return;

    Stage stage(device_, pipelines_, library_, std::move(scene));
    const Targets targets(device_, replay.size, stage.post());
    std::vector<Contender> contenders = make_contenders(replay);
    for (const uint32_t tick : ticks) run_tick(replay, stage, targets, contenders, tick);
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

  static Job job_of(const Replay& replay, const Stage& stage, const Contender& contender, uint32_t tick) {
    Job job;
    FrameResult& frame = job.frame;
    frame.scene = stage.scene().id;
    frame.tick = tick;
    frame.width = replay.size.x;
    frame.height = replay.size.y;
    frame.method = contender.instance.method->id();
    frame.settings = contender.settings;
    if (!contender.missing.empty()) {
      frame.status = fmt::format("unavailable: needs {}", fmt::join(contender.missing, ", "));
      return job;
    }
    const Capture& capture = replay.capture;
    if (!capture.ticks.empty() && !std::ranges::binary_search(capture.ticks, tick)) return job;
    const std::string stem = stem_of(frame.scene, tick, contender.label);
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

  void run_tick(const Replay& replay, Stage& stage, const Targets& targets,
                std::vector<Contender>& contenders, uint32_t tick) {
    std::vector<Job> jobs;
    for (const Contender& c : contenders) jobs.push_back(job_of(replay, stage, c, tick));
    const bool all_done =
        std::ranges::all_of(jobs, [&](const Job& job) { return finished(job) != results_.frames.end(); });
    if (all_done) {
      for (const Job& job : jobs) place(finished(job));
    } else {
      stop_if_interrupted();
      stage.go_to(tick, replay.size);
      const DrawnPicture reference = draw_reference(stage, targets);
      for (Contender& c : contenders) c.samples.clear(), c.transparency_ms.clear(), c.picture.reset();
      draw_contenders(replay, stage, targets, contenders);
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
      options_.progress(done_, total_, fmt::format("{} tick {}", stage.scene().id, tick));
  }

  DrawnPicture draw_reference(const Stage& stage, const Targets& targets) {
    if (!reference_.method)
      reference_ = {.method = make_method("reference"), .owner = "ground truth", .resources = {}};
    render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), reference_);
    return read_picture(device_, targets);
  }

  /// Repetitions of all methods in turn, so that a drift of the machine's speed meets them alike.
  void draw_contenders(const Replay& replay, const Stage& stage, const Targets& targets,
                       std::vector<Contender>& contenders) {
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
      if (!frame.image.empty()) write_png(options_.out / frame.image, contender.picture->display);
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
  size_t total_ = 0, done_ = 0;  // ticks
  size_t placed_ = 0;            // frames
};

}  // namespace

Results measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
                const std::vector<Replay>& replays, const MeasurementOptions& options) {
  return Measurement(device, pipelines, library, options).run(replays);
}

}  // namespace plume
