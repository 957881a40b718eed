// Whether a run is as accurate and as fast as an earlier one, its baseline: job by job, with tolerances.
//
// Errors compare as they are. Times of two machines, or of one machine on two days, do not: what compares is
// a method's own time over that of the exact `reference` in the same run, whose repetitions took turns with
// the method's. Its interval is the widest that the intervals of the two times allow.
//
// Limits: `reference` itself has no ratio, so that of its time nothing is said. A ratio also differs between
// devices of different make, so on another device errors are compared alone.
#ifndef PLUME_RUNS_BASELINE_H
#define PLUME_RUNS_BASELINE_H

#include "sandbox/runs/results.h"

namespace plume {

struct Tolerances {
  double error = 1.05;                ///< what RMSE and FLIP may grow by, as a factor
  std::optional<double> time = 1.15;  ///< the same of ratios of times; nothing: they are not compared
};
/// Errors that differ by less are the same, whatever their ratio: half floats are no finer.
constexpr double kErrorFloor = 1e-4;

struct BaselineVerdict {
  struct Finding {
    std::string job, what, before, after;
  };
  size_t compared = 0;  ///< jobs that both have
  std::vector<Finding> worse, better;
  std::vector<std::string> missing;  ///< jobs of the baseline that the run did not draw
  std::vector<std::string> added;    ///< jobs that the baseline does not have
  std::vector<std::string> notes;
  bool passed() const { return worse.empty() && missing.empty(); }
};

/// Throws std::runtime_error, which says what to do, when times are to be compared and the baseline drew no
/// `reference` beside the methods of some moment.
void require_ratios(const Results& baseline, const Tolerances& tolerances);

/// Jobs are the same when scene, tick, shot, size, seed, method and settings are; parameters that the
/// baseline does not know must have their defaults.
BaselineVerdict against_baseline(const Results& baseline, const Results& run, const Tolerances& tolerances);
/// For people: a line for each finding, and a first one that sums up.
std::string to_text(const BaselineVerdict& verdict, const std::string& baseline_name);

}  // namespace plume
#endif
