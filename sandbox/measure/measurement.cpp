#include "sandbox/measure/measurement.h"

#include <fmt/format.h>

#include <algorithm>
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
  std::string label;                  // file-name part: the id, and the settings that the replay names
  std::vector<std::string> missing;   // of the device
  std::vector<std::vector<gpu::PassTime>> samples;
  std::optional<DrawnPicture> picture;
};

bool is_finished(const Results& results, const FrameResult& wanted) {
  return std::any_of(results.frames.begin(), results.frames.end(), [&](const FrameResult& f) {
    return f.scene == wanted.scene && f.tick == wanted.tick && f.width == wanted.width && f.height == wanted.height &&
           f.method == wanted.method && f.settings == wanted.settings;
  });
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
    frame.passes.push_back({samples.front()[p].name, summarise(times)});
  }
}

json demand_json(const Stage& stage, const gpu::Pipelines& pipelines) {
  json instances = json::array();
  for (const InstanceDemand& d : stage.demand())
    instances.push_back({{"name", d.name},
                         {"called", d.called},
                         {"awake", d.awake},
                         {"why", d.why},
                         {"ticks_simulated", d.ticks_simulated},
                         {"dispatches", d.dispatches},
                         {"bytes", d.bytes}});
  return {{"scene", stage.scene().id},
          {"tick", stage.simulation().tick()},
          {"instances", instances},
          {"pipelines", pipelines.count()},
          {"state_hash", fmt::format("{:016x}", stage.simulation().state_hash())}};
}

class Measurement {
 public:
  Measurement(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
              const MeasurementOptions& options)
      : device_(device), pipelines_(pipelines), library_(library), options_(options) {
    std::filesystem::create_directories(options.out);
    const auto manifest = options.out / "results.json";
    if (options.resume && std::filesystem::exists(manifest)) results_ = read_results(manifest);
    results_.environment = environment(device);
  }

  Results run(const std::vector<Replay>& replays) {
    for (const Replay& replay : replays) total_ += replay.ticks.size();
    total_ = (total_ + options_.shard.count - 1 - options_.shard.index) / options_.shard.count;
    size_t job = 0;
    for (const Replay& replay : replays) run_replay(replay, job);
    write_manifest();
    return std::move(results_);
  }

 private:
  static json environment(const gpu::Device& device) {
    return {{"device", device.info().name}, {"driver", device.info().driver}, {"api", device.info().api},
            {"build", build_name()},        {"commit", build_commit()},       {"threads", std::thread::hardware_concurrency()}};
  }

  void run_replay(const Replay& replay, size_t& job) {
    Scene scene = library_.scene(replay.scene);
    if (auto unknown = check_references(scene, library_); !unknown.empty()) throw FileErrors(std::move(unknown));
    if (replay.seed) scene.seed = *replay.seed;
    if (!replay.camera.empty()) scene.camera = replay.camera;
    std::vector<uint32_t> ticks;
    for (const uint32_t tick : replay.ticks)
      if (job++ % options_.shard.count == options_.shard.index) ticks.push_back(tick);
    if (ticks.empty()) return;

    Stage stage(device_, pipelines_, library_, std::move(scene));
    const Targets targets(device_, replay.size);
    std::vector<Contender> contenders = make_contenders(replay);
    for (const uint32_t tick : ticks) run_tick(replay, stage, targets, contenders, tick);
  }

  std::vector<Contender> make_contenders(const Replay& replay) {
    std::vector<Contender> contenders;
    for (const MethodRun& run : replay.methods) {
      Contender c;
      c.instance.method = make_method(run.id);
      c.label = run.id;
      for (const auto& [name, value] : run.settings) {
        set_parameter(*c.instance.method, name, value);
        c.label += fmt::format("-{}-{}", name, value);
      }
      c.instance.owner = c.label;
      c.settings = parameter_values(*c.instance.method);
      c.missing = c.instance.method->missing(device_);
      contenders.push_back(std::move(c));
    }
    return contenders;
  }

  static FrameResult frame_of(const Replay& replay, const Stage& stage, const Contender& contender, uint32_t tick) {
    FrameResult frame;
    frame.scene = stage.scene().id;
    frame.tick = tick;
    frame.width = replay.size.x;
    frame.height = replay.size.y;
    frame.method = contender.instance.method->id();
    frame.settings = contender.settings;
    return frame;
  }

  void run_tick(const Replay& replay, Stage& stage, const Targets& targets, std::vector<Contender>& contenders,
                uint32_t tick) {
    const bool all_done = std::all_of(contenders.begin(), contenders.end(), [&](const Contender& c) {
      return is_finished(results_, frame_of(replay, stage, c, tick));
    });
    if (!all_done) {
      if (options_.interrupted && options_.interrupted()) throw Interrupted();
      stage.go_to(tick, replay.size);
      const DrawnPicture reference = draw_reference(stage, targets);
      for (Contender& c : contenders) c.samples.clear(), c.picture.reset();
      draw_contenders(replay, stage, targets, contenders);
      for (Contender& c : contenders) record(replay, stage, c, tick, reference);
      results_.demand = demand_json(stage, pipelines_);
      write_manifest();
    }
    ++done_;
    if (options_.progress) options_.progress(done_, total_, fmt::format("{} tick {}", stage.scene().id, tick));
  }

  DrawnPicture draw_reference(const Stage& stage, const Targets& targets) {
    if (!reference_.method) reference_ = {.method = make_method("reference"), .owner = "ground truth", .resources = {}};
    render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), reference_);
    return read_picture(device_, targets);
  }

  /// Repetitions of all methods in turn, so that a drift of the machine's speed meets them alike.
  void draw_contenders(const Replay& replay, const Stage& stage, const Targets& targets,
                       std::vector<Contender>& contenders) {
    for (uint32_t repetition = 0; repetition < replay.warmup + replay.frames; ++repetition)
      for (Contender& c : contenders) {
        if (!c.missing.empty()) continue;
        auto report = render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), c.instance);
        if (repetition >= replay.warmup) c.samples.push_back(std::move(report.passes));
        if (!c.picture) c.picture = read_picture(device_, targets);
      }
  }

  void record(const Replay& replay, const Stage& stage, const Contender& contender, uint32_t tick,
              const DrawnPicture& reference) {
    FrameResult frame = frame_of(replay, stage, contender, tick);
    if (is_finished(results_, frame)) return;
    if (!contender.missing.empty()) {
      frame.status = fmt::format("unavailable: needs {}", fmt::join(contender.missing, ", "));
      results_.frames.push_back(std::move(frame));
      return;
    }
    summarise_passes(contender.samples, frame);
    frame.memory_bytes = device_.memory().owner_bytes(contender.instance.owner);
    Raster<float> error_map;
    frame.error = compare(reference, *contender.picture, error_map);

    const auto& wanted = replay.capture.ticks;
    const bool capture = wanted.empty() || std::find(wanted.begin(), wanted.end(), tick) != wanted.end();
    const std::string stem = fmt::format("{}_{:06}_{}", frame.scene, tick, contender.label);
    if (capture && replay.capture.images) {
      frame.image = stem + ".png";
      write_png(options_.out / frame.image, contender.picture->display);
    }
    if (capture && replay.capture.error_maps) {
      frame.error_map = stem + "_error.png";
      write_png(options_.out / frame.error_map, magma_image(error_map));
    }
    if (capture && replay.capture.hdr) write_exr(options_.out / (stem + ".exr"), contender.picture->linear);
    results_.frames.push_back(std::move(frame));
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
  size_t total_ = 0, done_ = 0;
};

}  // namespace

Results measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
                const std::vector<Replay>& replays, const MeasurementOptions& options) {
  return Measurement(device, pipelines, library, options).run(replays);
}

}  // namespace plume
