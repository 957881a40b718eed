// The flags of drawing commands and their common end.
#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "renderer/methods/methods.h"
#include "sandbox/commands/command.h"
#include "sandbox/measure/report.h"

namespace plume {
namespace {

volatile std::sig_atomic_t g_interrupted = 0;

/// "12.5s", "3m 20s".
std::string duration(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f}s", seconds);
  return fmt::format("{:.0f}m {:02.0f}s", std::floor(seconds / 60), std::fmod(seconds, 60));
}

/// One line that is rewritten on a terminal, plain lines in a pipe.
class Progress {
 public:
  ~Progress() {
    if (line_is_open_) fmt::print(stderr, "\n");
  }
  void operator()(size_t done, size_t total, const std::string& what) {
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    const std::string eta = done < total ? duration(elapsed / double(done) * double(total - done)) + " left"
                                         : "done in " + duration(elapsed);
    line_is_open_ = terminal_ && done < total;
    fmt::print(stderr, "{}[{}/{}] {} · {}{}", terminal_ ? "\r\x1b[K" : "", done, total, what, eta,
               line_is_open_ ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool terminal_ = isatty(STDERR_FILENO), line_is_open_ = false;
};

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

Shard parse_shard(const std::string& text) {
  const auto parts = split(text, '/');
  const auto index = parts ? parse_number(parts->first) : std::nullopt;
  const auto count = parts ? parse_number(parts->second) : std::nullopt;
  if (!index || !count || *index >= *count)
    throw UsageError(fmt::format("--shard {}: expected I/N with I from 0 to N - 1, such as 0/4", text));
  return {*index, *count};
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
  add_picture_flags(command, flags);
  command.add_option_function<std::string>(
      "--shard", [&flags](const std::string& text) { flags.shard = parse_shard(text); },
      "I/N: only the I-th of N parts of the ticks, from 0");
  command.add_flag("--resume", flags.resume,
                   "keep the frames in --out and draw what is missing; scenes, scripts and --seed as before");
  command.add_flag("--json", flags.json, "print results.json on standard output instead of a table");
  command.add_option("--out", flags.out, "folder for images, results.json, results.csv, report.html")
      ->capture_default_str()
      ->check(
          [](const std::string& folder) { return folder.empty() ? "expected the name of a folder" : ""; });
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

gpu::DeviceOptions device_options(const DrawFlags& flags) {
  const char* fault = std::getenv("PLUME_FAULT");  // tests inject what drivers rarely do
  return {.select = flags.device,
          .validate = flags.validate,
          .memory_limit_bytes = flags.memory_limit_mib << 20,
          .fault = fault ? fault : ""};
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

int measure_and_report(std::vector<Replay> replays, const PresetLibrary& library, const DrawFlags& flags) {
  for (Replay& replay : replays) {
    if (flags.size) replay.size = *flags.size;
    if (flags.seed) replay.seed = flags.seed;
  }
  apply_settings(flags.set, replays);

  std::signal(SIGINT, [](int) {
    g_interrupted = 1;
    std::signal(SIGINT, SIG_DFL);  // who asks twice does not want to wait for the frame
  });
  GpuSession session(flags);
  Progress progress;
  const Results results = measure(session.device, session.pipelines, library, replays,
                                  {.out = flags.out,
                                   .resume = flags.resume,
                                   .shard = flags.shard,
                                   .progress = std::ref(progress),
                                   .interrupted = [] { return g_interrupted != 0; }});
  write_report(std::filesystem::path(flags.out) / "report.html", results);

  if (flags.json)
    fmt::print("{}\n", to_json(results).dump(2));
  else
    fmt::print("{}report: {}\n", to_table(results),
               (std::filesystem::path(flags.out) / "report.html").string());
  return report_validation(session.device);
}

}  // namespace plume
