// plume stress: every method on the hard cases; how far each is off, what it may be, and what is known of
// why.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "renderer/methods/methods.h"
#include "sandbox/commands/asked_command.h"
#include "sandbox/commands/command.h"
#include "sandbox/commands/interruption.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/report/page.h"
#include "sandbox/runs/environment.h"
#include "sandbox/stress/verdict.h"

namespace plume {
namespace {

struct StressFlags : DrawFlags {
  StressFlags() { out = "out/stress"; }
  std::vector<std::string> cases, methods{"all"};
};

/// Those that are asked for, in the order of reports. Throws UsageError.
std::vector<StressCase> asked_cases(const std::vector<std::string>& ids) {
  std::vector<StressCase> all = stress_cases(), asked;
  std::vector<std::string> known;
  for (const StressCase& hard : all) known.push_back(hard.id);
  for (const std::string& id : ids)
    if (std::ranges::find(known, id) == known.end())
      throw UsageError(fmt::format("unknown case `{}`, {}", id, suggestion(id, known)));
  for (StressCase& hard : all)
    if (ids.empty() || std::ranges::find(ids, hard.id) != ids.end()) asked.push_back(std::move(hard));
  return asked;
}

void list(const std::vector<StressCase>& cases) {
  for (const StressCase& hard : cases)
    fmt::print("{:<24} {:>4} pictures  {}\n{:<24}                {}\n", hard.id, hard.pictures.size(),
               hard.title, "", hard.trouble);
}

struct Row {
  const StressCase& hard;
  const MethodRun& method;
  const std::optional<StressFinding>& finding;
  StressBound bound;
  Verdict verdict;
  std::vector<std::string> missing;  // of the device
};

nlohmann::json to_json(const Row& row) {
  nlohmann::json made{{"case", row.hard.id},
                      {"method", row.method.id},
                      {"settings", row.method.settings},
                      {"verdict", kVerdictNames[size_t(row.verdict)]},
                      {"bound", {{"rmse", row.bound.rmse}, {"max", row.bound.max}}},
                      {"why", row.bound.known ? nlohmann::json(row.bound.known->why) : nlohmann::json()}};
  if (!row.missing.empty()) made["needs"] = row.missing;
  if (row.finding)
    made.update({{"rmse", row.finding->rmse},
                 {"max", row.finding->max},
                 {"picture", row.finding->picture},
                 {"pixel", {row.finding->pixel.x, row.finding->pixel.y}},
                 {"finite", row.finding->finite}});
  return made;
}

void print(const Row& row) {
  if (!row.finding)
    return fmt::print("  {:<11} {:<16} needs {}\n", "unavailable", row.method.id,
                      fmt::join(row.missing, ", "));
  const StressFinding& f = *row.finding;
  fmt::print("  {:<11} {:<16} RMSE {:7.2f} of {:6.2f}   max {:7.2f} of {:6.2f}   {} at {},{}{}{}\n",
             kVerdictNames[size_t(row.verdict)], row.method.id, 255 * f.rmse, 255 * row.bound.rmse,
             255 * f.max, 255 * row.bound.max, f.picture, f.pixel.x, f.pixel.y,
             f.finite ? "" : ", NOT FINITE",
             row.bound.known ? fmt::format(": {}", row.bound.known->why) : "");
}

nlohmann::json describe(const std::vector<StressCase>& cases) {
  nlohmann::json told = nlohmann::json::object();
  for (const StressCase& hard : cases)
    told[hard.id] = {{"title", hard.title}, {"trouble", hard.trouble}, {"pictures", hard.pictures.size()}};
  return told;
}

/// stress.json and report.html; gives the latter's name.
std::filesystem::path write_files(const std::filesystem::path& folder, const nlohmann::json& all) {
  write_file(folder / "stress.json", all.dump(2) + "\n");
  write_file(folder / "report.html", assemble_page("stress.html", all, ""));
  return folder / "report.html";
}

/// As it is set: what it needs may depend on that.
std::vector<std::string> missing_of(const gpu::Device& device, const MethodRun& run) {
  const auto method = make_method(run.id);
  for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
  return method->missing(device);
}

struct Tally {
  nlohmann::json rows = nlohmann::json::array();
  std::array<size_t, std::size(kVerdictNames)> counts{};
};

/// Takes the findings of a case into the tally, and prints those that say more than that a method passed.
void tell(const gpu::Device& device, const StressCase& hard, const std::vector<MethodRun>& methods,
          const std::vector<std::optional<StressFinding>>& findings, bool quiet, Tally& tally) {
  std::vector<std::string> passed;
  if (!quiet) fmt::print("{}: {}\n", hard.id, hard.title);
  for (size_t i = 0; i < methods.size(); ++i) {
    const auto method = make_method(methods[i].id);
    const Row row{hard,
                  methods[i],
                  findings[i],
                  bound_of(hard, *method),
                  verdict_of(hard, *method, findings[i]),
                  missing_of(device, methods[i])};
    ++tally.counts[size_t(row.verdict)];
    tally.rows.push_back(to_json(row));
    if (row.verdict == Verdict::kPassed)
      passed.push_back(methods[i].id);
    else if (!quiet)
      print(row);
  }
  if (!quiet && !passed.empty()) fmt::print("  {:<11} {}\n", "passed", fmt::join(passed, ", "));
  std::fflush(stdout);
}

int run_stress(const StressFlags& flags) {
  const std::vector<StressCase> cases = asked_cases(flags.cases);
  if (flags.list) {
    list(cases);
    return kDone;
  }
  std::vector<Replay> set(1);
  set[0].methods = method_runs(flags.methods);
  apply_settings(flags.set, set);
  const std::vector<MethodRun>& methods = set[0].methods;

  heed_interruptions();
  make_folder(flags.out);  // a place where nothing can be written is told of before minutes of drawing
  const SteadyTexts texts;
  const PresetLibrary library(preset_root());
  GpuSession session(flags);
  StressRun stress(session.device, session.pipelines, library);
  Tally tally;
  for (const StressCase& hard : cases) {
    if (is_interrupted()) throw Interrupted("interrupted; nothing is written");
    tell(session.device, hard, methods, stress.run(hard, methods), flags.json, tally);
  }
  const nlohmann::json all{{"environment", environment_of(session.device)},
                           {"command", shell_text(asked_arguments(*flags.command))},
                           {"cases", describe(cases)},
                           {"rows", std::move(tally.rows)}};
  const std::filesystem::path report = write_files(flags.out, all);
  if (flags.json)
    fmt::print("{}\n", all.dump(2));
  else {
    for (size_t v = 0; v < tally.counts.size(); ++v)
      if (tally.counts[v]) fmt::print("{}: {}\n", kVerdictNames[v], tally.counts[v]);
    fmt::print("report: {}\n", report.string());
  }
  const bool held = tally.counts[size_t(Verdict::kFailed)] + tally.counts[size_t(Verdict::kGone)] == 0;
  return std::max<int>(held ? kDone : kToleranceExceeded, report_validation(session.device));
}

}  // namespace

void add_stress(CLI::App& program, Run& run) {
  auto flags = std::make_shared<StressFlags>();
  CLI::App* command =
      program.add_subcommand("stress", "hard cases: how far each method is off, and what is known of why");
  flags->command = command;
  command->add_option("CASE", flags->cases, "ids of cases; otherwise all of them");
  command->add_option("--methods", flags->methods, "all, or ids of `plume list methods`, comma-separated")
      ->type_name("METHODS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_flag("--list", flags->list, "print the cases, and draw nothing");
  command->add_flag("--json", flags->json, "print stress.json on standard output instead of lines");
  command->add_option("--out", flags->out, "folder for stress.json and report.html")
      ->type_name("DIR")
      ->capture_default_str();
  add_device_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_stress(*flags); }; });
}

}  // namespace plume
