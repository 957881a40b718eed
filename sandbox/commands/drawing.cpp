// The common end of drawing commands: the GPU they open, what they measure, what they print.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "sandbox/commands/asked_command.h"
#include "sandbox/commands/command.h"
#include "sandbox/commands/interruption.h"
#include "sandbox/commands/isolated.h"
#include "sandbox/commands/job_list.h"
#include "sandbox/commands/progress.h"
#include "sandbox/report/report.h"
#include "sandbox/runs/sensitivity.h"
#include "sandbox/runs/times_alike.h"

namespace plume {
namespace {

/// Tests inject what drivers rarely do; with PLUME_FAULT_ONCE only into the process that makes that folder.
std::string injected_fault() {
  const char *fault = std::getenv("PLUME_FAULT"), *once = std::getenv("PLUME_FAULT_ONCE");
  return !fault || (once && !std::filesystem::create_directory(once)) ? "" : fault;
}

}  // namespace

gpu::DeviceOptions device_options(const DrawFlags& flags) {
  return {.select = flags.device,
          .validate = flags.validate,
          .memory_limit_bytes = flags.memory_limit_mib << 20,
          .fault = injected_fault()};
}

GpuSession::GpuSession(const gpu::DeviceOptions& options, const std::string& shader_folder)
    : device(options),
      shaders(shader_folder),
      kept(device, cache_folder()),
      pipelines(device, shaders, kept.bytes()) {
  if (const std::string& why = pipelines.cache().refused(); !why.empty())
    warn(fmt::format("{}: {}; pipelines are made anew", kept.file().string(), why));
}

GpuSession::~GpuSession() {
  if (std::uncaught_exceptions() > 0) return;  // the device may be the reason
  try {
    kept.keep(pipelines.cache());
  } catch (const std::exception& error) {
    warn(fmt::format("pipelines are not kept for the next run: {}", error.what()));
  }
}

void warn(const std::string& text) {
  fmt::print(stderr, "plume: note: {}\n", text);
}

int report_validation(const gpu::Device& device) {
  const auto messages = device.validation_messages();
  for (const std::string& message : messages) fmt::print(stderr, "validation: {}\n", message);
  return messages.empty() ? kDone : kToleranceExceeded;
}

void print_results(const Results& results, const OutputFlags& flags) {
  const std::filesystem::path report = std::filesystem::path(flags.out) / "report.html";
  write_report(report, results, flags.report_limit_mib << 20);
  for (const Note& note : results.notes) warn(note.text);
  for (const std::string& warning : bad_particle_warnings(results)) warn(warning);
  if (flags.json)
    fmt::print("{}\n", to_json(results).dump(2));
  else
    fmt::print("{}{}report: {}\n", to_table(results),
               results.sensitivity.is_null() ? times_alike(results) : to_table(parameter_changes(results)),
               report.string());
}

namespace {

/// Adds the moved parameters. Throws UsageError where their times could not be told apart.
void prepare_sensitivity(std::vector<Replay>& replays) {
  for (Replay& replay : replays) {
    if (replay.frames < kSamplesToTellApart)
      throw UsageError(
          fmt::format("--sensitivity: {} repetitions tell no times apart, expected --frames {} or more",
                      replay.frames, kSamplesToTellApart));
    add_moved_parameters(replay);
    replay.capture.images = replay.capture.error_maps = false;  // a picture for each would be too many
  }
}

/// Throws UsageError. --size, shots and sweeps have sizes of their own.
void refuse_pixels_outside(const std::vector<Replay>& replays) {
  for (const Replay& replay : replays) {
    std::vector<glm::uvec2> sizes(replay.shots.empty() ? 1 : 0, replay.size);
    for (const Shot& shot : replay.shots)
      sizes.push_back(shot.size == glm::uvec2(0) ? replay.size : shot.size);
    for (const glm::uvec2 pixel : replay.capture.pixels)
      for (const glm::uvec2 size : sizes)
        if (pixel.x >= size.x || pixel.y >= size.y)
          throw UsageError(fmt::format("{}: pixel {},{} is marked, but a picture of {}x{} ends at {},{}",
                                       replay.id, pixel.x, pixel.y, size.x, size.y, size.x - 1, size.y - 1));
  }
}

Manifest manifest_of(const Plan& plan, const std::string& command, const DrawFlags& flags) {
  Manifest manifest(plan, flags.out, command);
  if (flags.resume) manifest.go_on();
  return manifest;
}

/// What there is to say once all is drawn; gives the exit code of it.
int conclude(Results results, const std::optional<Results>& baseline, const DrawFlags& flags) {
  if (flags.as_job) return kDone;
  if (flags.sensitivity) {
    results.sensitivity = to_json(parameter_changes(results));
    write_results(flags.out, results);
  }
  print_results(results, flags);
  return baseline ? report_baseline(flags.baseline, *baseline, results, flags.json) : kDone;
}

}  // namespace

int measure_and_report(std::vector<Replay> replays, const PresetLibrary& library, const DrawFlags& flags) {
  for (Replay& replay : replays) {
    if (flags.size) replay.size = *flags.size;
    if (flags.seed) replay.seed = flags.seed;
    std::ranges::copy(flags.pixels, std::back_inserter(replay.capture.pixels));
  }
  refuse_pixels_outside(replays);
  apply_settings(flags.set, replays);
  if (flags.sensitivity) prepare_sensitivity(replays);

  const Plan plan = make_plan(library, std::move(replays), flags.shaders);
  const Selection selection = select_jobs(plan, flags.shard, flags.only);
  const std::vector<std::string> arguments = asked_arguments(*flags.command);
  const std::string command = shell_text(arguments);
  if (flags.list) {
    fmt::print("{}",
               flags.json ? job_list(plan, selection, command).dump(2) + "\n" : job_table(plan, selection));
    return kDone;
  }
  const auto baseline =
      read_baseline(flags.baseline, plan.replays, flags.shard.count == 1 && flags.only.empty());

  heed_interruptions();
  Progress progress;
  MeasurementOptions options{.selection = selection, .progress = {}, .interrupted = is_interrupted};
  if (!flags.as_job) options.progress = std::ref(progress);
  if (flags.isolate) {
    Manifest manifest = manifest_of(plan, command, flags);
    const IsolatedRun run = measure_isolated(plan, options, arguments, manifest);
    const int verdict = conclude(manifest.results(), baseline, flags);
    if (run.failed > 0)
      warn(fmt::format("{} of {} jobs failed, the others are kept: --resume tries again", run.failed,
                       plan.jobs));
    return run.failed > 0 ? kDeviceFailed : run.messages ? kToleranceExceeded : verdict;
  }
  GpuSession session(flags);
  Manifest manifest = manifest_of(plan, command, flags);
  measure(session.device, session.pipelines, library, plan, options, manifest);
  const int verdict = conclude(manifest.results(), baseline, flags);
  return std::max(verdict, report_validation(session.device));
}

}  // namespace plume
