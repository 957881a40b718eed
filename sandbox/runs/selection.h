// Which jobs of a plan a run draws: those of its shard, and of those the ones that are asked for by id.
#ifndef PLUME_RUNS_SELECTION_H
#define PLUME_RUNS_SELECTION_H

#include <string>
#include <vector>

#include "sandbox/runs/plan.h"

namespace plume {

/// A part of a plan for one of several machines.
struct Shard {
  uint32_t index = 0, count = 1;  ///< zero-based
  enum class By {
    kTurn,   ///< the first moment to the first, the second to the second, …
    kRange,  ///< the first part of the moments to the first, …: frames that follow each other stay together
    kJob     ///< jobs in turn, also those of one moment, whose times then are not of one machine
  } by = By::kTurn;
};

/// The places of a moment's jobs that are drawn; empty: none.
using Selection = std::vector<std::vector<size_t>>;

/// For each moment. `only`: ids of jobs, empty for all. Throws std::runtime_error that names the nearest id
/// when the plan has no such job.
Selection select_jobs(const Plan& plan, const Shard& shard, const std::vector<std::string>& only);

}  // namespace plume
#endif
