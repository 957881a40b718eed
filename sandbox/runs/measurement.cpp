#include "sandbox/runs/measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>

#include "renderer/methods/methods.h"
#include "sandbox/measure/error_map.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/flip.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/measure/inspector.h"
#include "sandbox/measure/metrics.h"
#include "sandbox/measure/picture.h"
#include "sandbox/measure/shortfalls.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/runs/environment.h"
#include "sandbox/runs/frame_probe.h"
#include "sandbox/runs/machine_load.h"
#include "sandbox/runs/repetitions.h"
#include "sandbox/scene/bad_particles.h"

namespace plume {
namespace {

using nlohmann::json;

/// A method at a moment, ready to draw, with what the repetitions gave.
struct Contender {
  MethodInstance instance;
  FrameResult frame;
  std::vector<std::string> missing;   // of the device
  std::vector<std::string> left_out;  // of the last drawing
  BadParticles bad_particles;         // likewise
  std::vector<std::vector<gpu::PassTime>> samples;
  std::vector<double> transparency_ms;  // of the same drawings
  std::optional<DrawnPicture> picture;
  json probes = json::array();
  std::optional<DisplayImage> view;  // in its place
};

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
  frame.gpu_ms = summarise(totals);
  for (size_t p = 0; p < samples.front().size(); ++p) {
    std::vector<double> times;
    for (const auto& sample : samples) times.push_back(sample[p].ms);
    frame.passes.push_back({samples.front()[p].name, summarise(times), samples.front()[p].fragments});
  }
}

json demand_json(const Stage& stage) {
  json result = plume::demand_json(stage.demand());
  result["state_hash"] = fmt::format("{:016x}", stage.simulation().state_hash());
  return result;
}

std::string name_of(const Stage& stage) {
  return fmt::format("{} tick {}", stage.scene().id, stage.simulation().tick());
}

class Measurement {
 public:
  Measurement(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, const Plan& plan,
              const MeasurementOptions& options, Manifest& manifest)
      : device_(device),
        pipelines_(pipelines),
        library_(library),
        plan_(plan),
        options_(options),
        manifest_(manifest) {
    manifest.set_environment(environment_of(device));
  }

  void run() try {
    find_what_is_left();
    manifest_.write(Manifest::When::kNow);  // what an earlier run left here is over from now on
    for (size_t first = 0; first < plan_.moments.size();) {
      size_t end = first;
      while (end < plan_.moments.size() && plan_.moments[end].replay == plan_.moments[first].replay) ++end;
      run_replay(first, end);
      first = end;
    }
    manifest_.write(Manifest::When::kNow);
  } catch (...) {
    manifest_.write_what_is_done();
    throw;
  }

 private:
  void find_what_is_left() {
    const auto moments = [](const Selection& selection) {
      return size_t(std::ranges::count_if(selection, [](const auto& jobs) { return !jobs.empty(); }));
    };
    left_ = manifest_.left_of(options_.selection);
    headway_.total = moments(options_.selection), headway_.to_draw = moments(left_);
    headway_.done = headway_.total - headway_.to_draw;
    if (headway_.done > 0) tell("kept from an earlier run");
  }

  void tell(std::string what, double within = 0.0) {
    headway_.what = std::move(what), headway_.within = within;
    if (options_.progress) options_.progress(headway_);
  }

  /// Moments of one replay. What one after the other has in common stays: the scene and the images.
  void run_replay(size_t first, size_t end) {
    while (end > first && left_[end - 1].empty()) --end;
    std::optional<Stage> stage;
    std::optional<Targets> targets;
    const std::string* scene = nullptr;
    for (size_t m = first; m < end; ++m) {
      const Moment& moment = plan_.moments[m];
      if (!moment.shot && left_[m].empty()) continue;
      if (!scene || *scene != moment.scene_name) {
        scene = &moment.scene_name;
        targets.reset();
        stage.reset();
        stage.emplace(device_, pipelines_, library_.behind(plan_.replays[moment.replay].presets),
                      plan_.scenes[moment.replay].at(*scene));
      }
      // A shot that is not drawn here still is part of what those after it remember.
      const bool remembers = moment.shot && stage->remembers();
      if (left_[m].empty() && !remembers) continue;
      if (!remembers) stage->start_over();
      if (!left_[m].empty()) stop_if_interrupted();
      stage->go_to(moment.tick, moment.size, moment.camera);
      if (left_[m].empty()) continue;
      if (!targets || targets->size != moment.size) targets.emplace(device_, moment.size, stage->post());
      run_moment(moment, left_[m], *stage, *targets);
    }
  }

  std::vector<Contender> contenders_of(const Moment& moment, const std::vector<size_t>& jobs) {
    std::vector<Contender> contenders;
    for (const size_t job : jobs) {
      Contender& c = contenders.emplace_back();
      c.frame = planned_frame(plan_, moment, moment.jobs[job]);
      const MethodRun& run = plan_.replays[moment.replay].methods[moment.jobs[job].method];
      c.instance.method = make_method(run.id);
      for (const auto& [name, value] : run.settings) set_parameter(*c.instance.method, name, value);
      c.instance.owner = moment.jobs[job].id;
      c.missing = c.instance.method->missing(device_);
    }
    return contenders;
  }

  void run_moment(const Moment& moment, const std::vector<size_t>& jobs, Stage& stage,
                  const Targets& targets) {
    const Replay& replay = plan_.replays[moment.replay];
    std::vector<Contender> contenders = contenders_of(moment, jobs);
    const DrawnPicture reference = draw_reference(stage, targets);
    const std::span<const glm::uvec2> pixels = replay.capture.pixels;
    const auto marked = probe_marked(device_, pipelines_, stage, targets,
                                     is_captured(replay.capture, moment.tick) ? pixels : pixels.first(0));
    draw_contenders(replay, stage, targets, contenders, marked);
    if (!moment.view.id.empty()) look_at(moment.view, stage, targets, contenders.front());
    // Before any frame counts as done: the last thing asked of the device, which may fail too.
    MomentResult result{.job = moment.jobs.front().id,
                        .scene = moment.scene,
                        .tick = moment.tick,
                        .shot = moment.shot,
                        .seed = moment.seed,
                        .width = moment.size.x,
                        .height = moment.size.y,
                        .demand = demand_json(stage)};
    for (size_t i = 0; i < jobs.size(); ++i) {
      record(contenders[i], reference);
      manifest_.record(moment, jobs[i], std::move(contenders[i].frame));
    }
    manifest_.record(moment, std::move(result));
    take_notes();
    manifest_.write(Manifest::When::kSparingly);
    ++headway_.done, ++headway_.drawn;
    tell(name_of(stage));
  }

  DrawnPicture draw_reference(const Stage& stage, const Targets& targets) {
    if (!reference_.method)
      reference_ = {.method = make_method("reference"), .owner = "ground truth", .resources = {}};
    render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), reference_);
    return read_picture(device_, targets);
  }

  /// Repetitions of all methods in turn, so that a drift of the machine's speed meets them alike.
  void draw_contenders(const Replay& replay, const Stage& stage, const Targets& targets,
                       std::span<Contender> contenders, std::span<const PixelProbe> marked) {
    std::vector<double> repetitions_ms;  // of all
    const uint32_t repetitions = replay.warmup + replay.frames;
    for (uint32_t repetition = 0; repetition < repetitions; ++repetition)
      for (size_t turn = 0; turn < contenders.size(); ++turn) {
        Contender& c = contenders[whose_turn(turn, contenders.size(), repetition)];
        if (!c.missing.empty()) continue;
        stop_if_interrupted();
        if (const size_t drawings = repetition * contenders.size() + turn; drawings > 0)
          tell(name_of(stage), double(drawings) / double(repetitions * contenders.size()));
        auto report =
            render_frame(device_, pipelines_, targets, stage.prelude(), stage.transparents(), c.instance);
        c.left_out = std::move(report.left_out);
        c.bad_particles = bad_particles(stage);
        if (repetition >= replay.warmup) {
          repetitions_ms.resize(repetition - replay.warmup + 1);
          repetitions_ms.back() += report.transparency_ms;
          c.samples.push_back(std::move(report.passes));
          c.transparency_ms.push_back(report.transparency_ms);
        }
        if (c.picture) continue;
        c.picture = read_picture(device_, targets);
        c.probes = frame_probes(device_, pipelines_, stage, targets, c.instance, marked);
      }
    if (const auto ratio = drift(repetitions_ms))
      drifts_.push_back(
          {"drift",
           fmt::format("At {} the later half of the repetitions took {:.2f} times as long as the earlier: a "
                       "clock or a load changed.",
                       name_of(stage), *ratio)});
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

  /// Measures and writes the files.
  void record(Contender& contender, const DrawnPicture& reference) {
    FrameResult& frame = contender.frame;
    if (!contender.missing.empty()) {
      frame.status = fmt::format("unavailable: needs {}", fmt::join(contender.missing, ", "));
      frame.image.clear(), frame.error_map.clear(), frame.hdr.clear();
      return;
    }
    summarise_passes(contender.samples, frame);
    frame.transparency_ms = summarise(contender.transparency_ms);
    frame.probes = contender.probes;
    frame.statistics = contender.instance.method->statistics(device_, contender.instance.resources);
    frame.shortfalls = shortfall_sentences(*contender.instance.method, frame.statistics);
    frame.left_out = contender.left_out;
    frame.bad_particles = to_json(contender.bad_particles);
    if (const BadParticles& bad = contender.bad_particles; bad.count > 0)
      frame.shortfalls.push_back(fmt::format("{}. {}.", to_text(bad), remedy(bad)));
    frame.memory_bytes = device_.memory().owner_bytes(contender.instance.owner);
    Raster<float> error_map;
    frame.error = compare(reference, *contender.picture, error_map);
    const std::filesystem::path& out = manifest_.folder();
    if (!frame.image.empty())
      write_png(out / frame.image, contender.view.value_or(contender.picture->display));
    if (!frame.error_map.empty()) write_png(out / frame.error_map, magma_image(error_map));
    if (!frame.hdr.empty()) write_exr(out / frame.hdr, contender.picture->linear);
  }

  void take_notes() {
    std::vector<Note> notes = drifts_;
    std::ranges::move(load_notes(load_before_, read_machine_load(), std::thread::hardware_concurrency()),
                      std::back_inserter(notes));
    manifest_.set_notes(std::move(notes));
  }

  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  const PresetLibrary& library_;
  const Plan& plan_;
  const MeasurementOptions& options_;
  Manifest& manifest_;
  const MachineLoad load_before_ = read_machine_load();
  std::vector<Note> drifts_;
  MethodInstance reference_;
  Inspector inspector_;
  Selection left_;  // to be drawn
  Headway headway_;
};

}  // namespace

void measure(gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library, const Plan& plan,
             const MeasurementOptions& options, Manifest& manifest) {
  Measurement(device, pipelines, library, plan, options, manifest).run();
}

}  // namespace plume
