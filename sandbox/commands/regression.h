// --baseline: a run held against an earlier one.
#ifndef PLUME_COMMANDS_REGRESSION_H
#define PLUME_COMMANDS_REGRESSION_H

#include <CLI/CLI.hpp>

#include "sandbox/runs/baseline.h"
#include "sandbox/scene/replay.h"

namespace plume {

struct BaselineFlags {
  std::string file;  ///< "": there is none
  Tolerances tolerances;
};
void add_baseline_flags(CLI::App& command, BaselineFlags& flags, const std::string& group);

/// Read before anything is drawn, since it may lie where the results will. Throws UsageError when what will
/// be drawn cannot be held against it.
std::optional<Results> read_baseline(const BaselineFlags& flags, const std::vector<Replay>& replays,
                                     bool draws_all);

/// Prints the verdict, to standard error where standard output is JSON; gives the exit code of it.
int report_baseline(const BaselineFlags& flags, const Results& baseline, const Results& run, bool json);

}  // namespace plume
#endif
