#include "sandbox/commands/regression.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "sandbox/commands/command.h"

namespace plume {
namespace {

double parse_tolerance(const char* flag, const std::string& text, const char* or_else) {
  double factor = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), factor);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(factor) || factor < 1.0)
    throw UsageError(
        fmt::format("{} {}: expected a factor of at least 1, such as 1.1{}", flag, text, or_else));
  return factor;
}

}  // namespace

void add_baseline_flags(CLI::App& command, BaselineFlags& flags, const std::string& group) {
  command
      .add_option("--baseline", flags.file,
                  "results.json of an earlier run: exit 1 where this one is less accurate or slower")
      ->type_name("FILE")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--tolerance-error",
          [&flags](const std::string& text) {
            flags.tolerances.error = parse_tolerance("--tolerance-error", text, "");
          },
          "factor by which RMSE and FLIP may be above the baseline's [1.05]")
      ->type_name("FACTOR")
      ->group(group);
  command
      .add_option_function<std::string>(
          "--tolerance-time",
          [&flags](const std::string& text) {
            if (text == "off")
              flags.tolerances.time.reset();
            else
              flags.tolerances.time = parse_tolerance("--tolerance-time", text, ", or off");
          },
          "the same of own times as ratios to the reference's [1.15], or off: then it need not be drawn")
      ->type_name("FACTOR")
      ->group(group);
}

std::optional<Results> read_baseline(const BaselineFlags& flags, const std::vector<Replay>& replays,
                                     bool draws_all) {
  if (flags.file.empty()) return std::nullopt;
  if (!draws_all)
    throw UsageError(
        "--baseline: only a part of the jobs is drawn, and the rest would be missing: draw all of them");
  Results baseline = read_results(flags.file);
  if (flags.tolerances.time)
    for (const Replay& replay : replays)
      if (!replay.shots.empty() ||
          std::ranges::find(replay.methods, "reference", &MethodRun::id) == replay.methods.end())
        throw UsageError(fmt::format(
            "--baseline: times are compared as ratios to that of `reference`, which {} does not draw beside "
            "each method: add it to the methods, or give --tolerance-time off",
            replay.id));
  require_ratios(baseline, flags.tolerances);
  return baseline;
}

int report_baseline(const BaselineFlags& flags, const Results& baseline, const Results& run, bool json) {
  const BaselineVerdict verdict = against_baseline(baseline, run, flags.tolerances);
  fmt::print(json ? stderr : stdout, "{}", to_text(verdict, flags.file));
  return verdict.passed() ? kDone : kToleranceExceeded;
}

}  // namespace plume
