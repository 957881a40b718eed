// results.json and results.csv of a run while it grows: what is known of each job of a plan, in the plan's
// order. An interrupted run leaves what it had, and another goes on from there.
#ifndef PLUME_RUNS_MANIFEST_H
#define PLUME_RUNS_MANIFEST_H

#include <chrono>
#include <filesystem>
#include <optional>
#include <vector>

#include "sandbox/runs/folder_lock.h"
#include "sandbox/runs/plan.h"
#include "sandbox/runs/selection.h"

namespace plume {

class Manifest {
 public:
  /// Makes the folder. Throws FileError, and std::runtime_error where another run writes into it.
  Manifest(const Plan& plan, std::filesystem::path folder, std::string command);

  /// Takes over what an earlier run left in the folder, if any. Throws std::runtime_error when that is of
  /// another plan.
  void go_on();
  /// What jobs are measured with. Throws std::runtime_error when those taken over were measured with other
  /// things.
  void set_environment(const nlohmann::json& environment);

  /// What makes times of this run doubtful, beside what was noted of those taken over.
  void set_notes(std::vector<Note> notes);

  /// Whether nothing is left to be drawn of it: its result is known and its files are there.
  bool is_done(const Moment& moment, size_t job) const;
  /// Of these jobs, those that are not done.
  Selection left_of(Selection selection) const;
  void record(const Moment& moment, size_t job, FrameResult frame);
  void record(const Moment& moment, MomentResult result);

  /// Writes both files; `sparingly`: unless that would cost more than a tenth of the time since it began.
  enum class When { kNow, kSparingly };
  void write(When when);
  /// Writes both while an error is on its way to the user, whose place no other takes: where writing fails
  /// too, what was written last stays, and fewer frames are kept.
  void write_what_is_done() noexcept;

  const std::filesystem::path& folder() const { return folder_; }
  Results results() const;

 private:
  const Plan& plan_;
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;                  // once the folder is there
  Results head_;                                    // without frames and moments
  std::vector<Note> earlier_notes_;                 // of a run that this one goes on from
  std::vector<std::optional<FrameResult>> frames_;  // of each job
  std::map<size_t, MomentResult> moments_;          // by their first job
  using Clock = std::chrono::steady_clock;
  Clock::time_point written_;
  Clock::duration writing_{};  // took
};

/// Those things of an environment that must be equal for results to stand side by side: for each that is not,
/// its name and both values.
struct Disagreement {
  std::string name;
  nlohmann::json first, second;
};
std::optional<Disagreement> disagreement(const nlohmann::json& first, const nlohmann::json& second);

/// results.json and results.csv of `results` in a folder that is there. Throws FileError.
void write_results(const std::filesystem::path& folder, const Results& results);

}  // namespace plume
#endif
