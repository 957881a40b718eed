#include "sandbox/commands/isolated.h"

#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "renderer/gpu/errors.h"
#include "sandbox/commands/child.h"
#include "sandbox/commands/command.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/runs/machine_load.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

size_t jobs_in(const Selection& selection) {
  size_t jobs = 0;
  for (const std::vector<size_t>& of_moment : selection) jobs += of_moment.size();
  return jobs;
}

class Isolation {
 public:
  Isolation(const Plan& plan, const MeasurementOptions& options, const std::vector<std::string>& arguments,
            Manifest& manifest)
      : plan_(plan),
        options_(options),
        arguments_(arguments),
        manifest_(manifest),
        folder_(manifest.folder() / ".jobs") {}
  ~Isolation() { clear(); }
  Isolation(const Isolation&) = delete;

  IsolatedRun run() try {
    clear();  // what a killed run left
    const Selection left = manifest_.left_of(options_.selection);
    headway_.total = jobs_in(options_.selection), headway_.to_draw = jobs_in(left);
    headway_.done = headway_.total - headway_.to_draw;
    if (headway_.done > 0) tell("kept from an earlier run");
    manifest_.write(Manifest::When::kNow);
    for (size_t m = 0; m < left.size(); ++m)
      for (const size_t job : left[m]) {
        if (options_.interrupted && options_.interrupted()) throw Interrupted();
        run_job(plan_.moments[m], job);
      }
    if (headway_.drawn > 0)
      manifest_.set_notes(load_notes(load_before_, read_machine_load(), std::thread::hardware_concurrency()));
    manifest_.write(Manifest::When::kNow);
    return outcome_;
  } catch (...) {
    manifest_.write_what_is_done();
    throw;
  }

 private:
  void clear() const {
    std::error_code absent;
    fs::remove_all(folder_, absent);
  }

  void run_job(const Moment& moment, size_t place) {
    const Job& job = moment.jobs[place];
    Ending ending = draw(job);
    if (has_failed(ending)) {
      warn(fmt::format("{}: {}; trying once more", job.id, why(ending)));
      ending = draw(job);
    }
    if (has_failed(ending)) {
      FrameResult frame = planned_frame(plan_, moment, job);
      frame.image.clear(), frame.error_map.clear(), frame.hdr.clear();
      frame.status = "failed: " + why(ending);
      warn(fmt::format("{}: {}", job.id, frame.status));
      manifest_.record(moment, place, std::move(frame));
      ++outcome_.failed;
    } else {
      take_over(moment, place);
    }
    if (ending.exit_code == kToleranceExceeded) {
      fmt::print(stderr, "{}", ending.errors);
      outcome_.messages = true;
    }
    clear();
    manifest_.write(Manifest::When::kSparingly);
    ++headway_.done, ++headway_.drawn;
    tell(job.id);
  }

  void tell(std::string what) {
    headway_.what = std::move(what);
    if (options_.progress) options_.progress(headway_);
  }

  Ending draw(const Job& job) const {
    clear();
    std::vector<std::string> arguments = arguments_;
    arguments.insert(arguments.end(), {"--only", job.id, "--out", (folder_ / job.id).string(), "--as-job"});
    const Ending ending = run_child(arguments, options_.interrupted);
    // Ctrl+C reaches both, and ours on top of it is the second, which ends the job at once.
    if (ending.signal == SIGINT || ending.exit_code == kInterrupted) throw Interrupted();
    if (ending.exit_code == kNoDevice) throw gpu::NoUsableDevice(why(ending));
    // A full disk, a preset that broke: no other job would fare better.
    if (ending.exit_code == kBadUsage) throw std::runtime_error(fmt::format("{}: {}", job.id, why(ending)));
    return ending;
  }

  static bool has_failed(const Ending& ending) {
    return ending.signal || (ending.exit_code != kDone && ending.exit_code != kToleranceExceeded);
  }

  void take_over(const Moment& moment, size_t place) {
    const fs::path from = folder_ / moment.jobs[place].id;
    Results results = read_results(from / "results.json");
    if (results.plan != plan_.id)
      throw std::runtime_error("scripts or presets were edited while the run went on: start it again");
    manifest_.set_environment(results.environment);
    FrameResult frame = std::move(results.frames.at(0));
    for (const std::string& file : {frame.image, frame.error_map, frame.hdr})
      if (!file.empty()) rename_file(from / file, manifest_.folder() / file);
    manifest_.record(moment, place, std::move(frame));
    manifest_.record(moment, std::move(results.moments.at(0)));
  }

  const Plan& plan_;
  const MeasurementOptions& options_;
  const std::vector<std::string>& arguments_;
  Manifest& manifest_;
  const MachineLoad load_before_ = read_machine_load();
  fs::path folder_;  // of what is being drawn
  Headway headway_;
  IsolatedRun outcome_;
};

}  // namespace

IsolatedRun measure_isolated(const Plan& plan, const MeasurementOptions& options,
                             const std::vector<std::string>& arguments, Manifest& manifest) {
  return Isolation(plan, options, arguments, manifest).run();
}

}  // namespace plume
