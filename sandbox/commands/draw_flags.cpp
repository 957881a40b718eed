// The flags of drawing commands.
#include <fmt/format.h>

#include <charconv>

#include "renderer/methods/methods.h"
#include "sandbox/commands/asked_command.h"
#include "sandbox/commands/command.h"

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

void add_device_flags(CLI::App& command, DrawFlags& flags) {
  command
      .add_option("--device", flags.device, "part of a device's name, or its index in `plume list devices`")
      ->type_name("DEVICE");
  command.add_option("--set", flags.set, "of a method; see `plume list methods`")
      ->type_name("METHOD.PARAMETER=VALUE")
      ->allow_extra_args(false);
  command.add_flag("--validate", flags.validate,
                   "run with the Vulkan validation layer; any message makes the exit code 1");
  command
      .add_option("--shaders", flags.shaders, "compile shaders from this folder instead of the embedded ones")
      ->type_name("DIR");
  command.add_option("--memory-limit", flags.memory_limit_mib, "MiB of device memory that may be used")
      ->type_name("MIB")
      ->check(CLI::Range(1, 1 << 24));
}

void add_picture_flags(CLI::App& command, DrawFlags& flags) {
  command
      .add_option_function<std::string>(
          "--size", [&flags](const std::string& text) { flags.size = parse_size(text); },
          "picture size (1x1 to 16384x16384)")
      ->type_name("WxH");
  command.add_option("--seed", flags.seed, "instead of the scene's")
      ->type_name("N")
      ->check(CLI::Range(uint32_t(0), UINT32_MAX));
  add_device_flags(command, flags);
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
          "keep each method's transmittance over depth there, and the exact one; may be repeated")
      ->type_name("X,Y")
      ->allow_extra_args(false);
  command.add_flag("--list", flags.list, "print the jobs, each with its id, and draw nothing")
      ->group(kThisRun);
  command.add_option("--only", flags.only, "of --list: draw this one alone; may be repeated")
      ->type_name("JOB")
      ->allow_extra_args(false)
      ->group(kThisRun);
  command
      .add_option_function<std::string>(
          "--shard",
          [&flags](const std::string& text) {
            const Shard part = parse_shard(text);
            flags.shard.index = part.index, flags.shard.count = part.count;
          },
          "only the I-th of N parts of the ticks, from 0")
      ->type_name("I/N")
      ->group(kThisRun);
  command
      .add_option_function<std::string>(
          "--by", [&flags](const std::string& text) { flags.shard.by = parse_dealing(text); },
          "--shard deals ticks one after the other (turn), in N parts that follow each other (range), or "
          "each job of a tick by itself (job)")
      ->type_name("WAY")
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
      ->type_name("MIB")
      ->check(CLI::Range(1, 1 << 10))
      ->capture_default_str()
      ->group(group);
  command.add_option("--out", flags.out, "folder for images, results.json, results.csv, report.html")
      ->type_name("DIR")
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

}  // namespace plume
