// The flags of drawing commands and their common end.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "renderer/methods/methods.h"
#include "sandbox/commands/asked_command.h"
#include "sandbox/commands/command.h"
#include "sandbox/commands/interruption.h"
#include "sandbox/commands/isolated.h"
#include "sandbox/commands/job_list.h"
#include "sandbox/commands/progress.h"
#include "sandbox/measure/sensitivity.h"
#include "sandbox/measure/times_alike.h"
#include "sandbox/report/report.h"

namespace plume {
namespace {

/// A whole unsigned number, or nothing.
std::optional<uint32_t> parse_number(std::string_view text) {
  uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Both sides of the first `separator`.
std::optional<std::pair<std::string, std::string>> split(const std::string& text, char separator) {
  const size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  return std::pair{text.substr(0, at), text.substr(at + 1)};
}

/// "X,Y". Throws UsageError.
glm::uvec2 parse_pixel(const std::string& text) {
  const auto parts = split(text, ',');
  const auto x = parts ? parse_number(parts->first) : std::nullopt;
  const auto y = parts ? parse_number(parts->second) : std::nullopt;
  if (!x || !y)
    throw UsageError(
        fmt::format("--pixel {}: expected X,Y from the upper left, from 0, such as 320,180", text));
  return {*x, *y};
}

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

/// --size and shots have sizes of their own.
void refuse_pixels_outside(const std::vector<Replay>& replays) {
  for (const Replay& replay : replays) {
    std::vector<glm::uvec2> sizes(replay.ticks.empty() ? 0 : 1, replay.size);
    for (const Shot& shot : replay.shots)
      sizes.push_back(shot.size == glm::uvec2(0) ? replay.size : shot.size);
    for (const glm::uvec2 pixel : replay.capture.pixels)
      for (const glm::uvec2 size : sizes)
        if (pixel.x >= size.x || pixel.y >= size.y)
          throw UsageError(fmt::format("{}: pixel {},{} is marked, but a picture of {}x{} ends at {},{}",
                                       replay.id, pixel.x, pixel.y, size.x, size.y, size.x - 1, size.y - 1));
  }
}

Shard parse_shard(const std::string& text) {
  const auto parts = split(text, '/');
  const auto index = parts ? parse_number(parts->first) : std::nullopt;
  const auto count = parts ? parse_number(parts->second) : std::nullopt;
  if (!index || !count || *index >= *count)
    throw UsageError(fmt::format("--shard {}: expected I/N with I from 0 to N - 1, such as 0/4", text));
  return {.index = *index, .count = *count};
}

Shard::By parse_dealing(const std::string& text) {
  if (text == "turn") return Shard::By::kTurn;
  if (text == "range") return Shard::By::kRange;
  if (text == "job") return Shard::By::kJob;
  throw UsageError(fmt::format("--by {}: expected turn, range or job", text));
}

}  // namespace

glm::uvec2 parse_size(const std::string& text) {
  const auto parts = split(text, 'x');
  const auto width = parts ? parse_number(parts->first) : std::nullopt;
  const auto height = parts ? parse_number(parts->second) : std::nullopt;
  const auto fits = [](std::optional<uint32_t> n) { return n && *n >= 1 && *n <= 16384; };
  if (!fits(width) || !fits(height))
    throw UsageError(fmt::format("--size {}: expected WxH with both from 1 to 16384, such as 640x360", text));
  return {*width, *height};
}

void add_picture_flags(CLI::App& command, DrawFlags& flags) {
  command.add_option_function<std::string>(
      "--size", [&flags](const std::string& text) { flags.size = parse_size(text); },
      "picture size, WxH, 1x1 to 16384x16384");
  command.add_option("--seed", flags.seed, "instead of the scene's")
      ->check(CLI::Range(uint32_t(0), UINT32_MAX));
  command.add_option("--device", flags.device,
                     "part of a device's name, or its index in `plume list devices`");
  command.add_option("--set", flags.set, "method.parameter=value; see `plume list methods`")
      ->allow_extra_args(false);
  command.add_flag("--validate", flags.validate,
                   "run with the Vulkan validation layer; any message makes the exit code 1");
  command.add_option("--shaders", flags.shaders,
                     "compile shaders from this folder instead of the embedded ones");
  command.add_option("--memory-limit", flags.memory_limit_mib, "MiB of device memory that may be used")
      ->check(CLI::Range(1, 1 << 24));
}

void add_draw_flags(CLI::App& command, DrawFlags& flags) {
  flags.command = &command;
  add_picture_flags(command, flags);
  command
      .add_option_function<std::vector<std::string>>(
          "--pixel",
          [&flags](const std::vector<std::string>& texts) {
            flags.pixels.clear();
            for (const std::string& text : texts) flags.pixels.push_back(parse_pixel(text));
          },
          "X,Y, repeatable: keep each method's transmittance over depth there, and the exact one")
      ->allow_extra_args(false);
  command.add_flag("--list", flags.list, "print the jobs, each with its id, and draw nothing")
      ->group(kThisRun);
  command.add_option("--only", flags.only, "JOB of --list: draw this one alone; may be given again")
      ->allow_extra_args(false)
      ->group(kThisRun);
  command
      .add_option_function<std::string>(
          "--shard",
          [&flags](const std::string& text) {
            const Shard part = parse_shard(text);
            flags.shard.index = part.index, flags.shard.count = part.count;
          },
          "I/N: only the I-th of N parts of the ticks, from 0")
      ->group(kThisRun);
  command
      .add_option_function<std::string>(
          "--by", [&flags](const std::string& text) { flags.shard.by = parse_dealing(text); },
          "turn, range or job: --shard deals ticks one after the other, in N parts that follow each other, "
          "or each job of a tick by itself")
      ->group(kThisRun);
  command
      .add_flag(
          "--isolate", flags.isolate,
          "draw each job in a process of its own: a lost device or a crash costs that job, which is tried "
          "once more")
      ->group(kThisRun);
  command.add_flag("--as-job", flags.as_job, "print nothing and write no report: what --isolate runs")
      ->group("");
  command
      .add_flag("--resume", flags.resume,
                "keep the frames in --out and draw what is missing; scenes, scripts and flags as before")
      ->group(kThisRun);
  add_baseline_flags(command, flags.baseline, kThisRun);
  add_output_flags(command, flags, kThisRun);
}

void add_output_flags(CLI::App& command, OutputFlags& flags, const std::string& group) {
  command.add_flag("--json", flags.json, "print results.json on standard output instead of a table")
      ->group(group);
  command
      .add_option("--report-limit", flags.report_limit_mib,
                  "MiB that report.html may have: pictures in it are made smaller to fit")
      ->check(CLI::Range(1, 1 << 10))
      ->capture_default_str()
      ->group(group);
  command.add_option("--out", flags.out, "folder for images, results.json, results.csv, report.html")
      ->capture_default_str()
      ->check([](const std::string& folder) { return folder.empty() ? "expected the name of a folder" : ""; })
      ->group(group);
}

std::vector<MethodRun> method_runs(const std::vector<std::string>& names) {
  std::vector<MethodRun> runs;
  for (const std::string& name : names) {
    if (name == "all") {
      for (const std::string& id : method_ids()) runs.push_back({.id = id, .settings = {}});
      continue;
    }
    if (!make_method(name))
      throw UsageError(
          fmt::format("--methods: unknown method `{}`, {}", name, suggestion(name, method_ids())));
    runs.push_back({.id = name, .settings = {}});
  }
  return runs;
}

void apply_settings(const std::vector<std::string>& settings, std::vector<Replay>& replays) {
  for (const std::string& setting : settings) {
    const auto assignment = split(setting, '=');
    const auto name = assignment ? split(assignment->first, '.') : std::nullopt;
    if (!name)
      throw UsageError(
          fmt::format("--set {}: expected method.parameter=value, such as wboit.weight=eq9", setting));
    const auto method = make_method(name->first);
    if (!method)
      throw UsageError(fmt::format("--set {}: unknown method `{}`, {}", setting, name->first,
                                   suggestion(name->first, method_ids())));
    set_parameter(*method, name->second, assignment->second);  // says what is wrong before anything runs
    bool changes = false;
    for (Replay& replay : replays)
      for (MethodRun& run : replay.methods)
        if (run.id == name->first)
          changes |= run.settings.try_emplace(name->second, assignment->second).second;
    if (!changes)
      throw UsageError(
          fmt::format("--set {}: changes nothing, since {} is not drawn or has its {} set already", setting,
                      name->first, name->second));
  }
}

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
  if (flags.json)
    fmt::print("{}\n", to_json(results).dump(2));
  else
    fmt::print("{}{}report: {}\n", to_table(results),
               results.sensitivity.is_null() ? times_alike(results) : to_table(parameter_changes(results)),
               report.string());
}

namespace {

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
