// Parts of one plan, drawn on several machines, put together as one machine would have left them.
#ifndef PLUME_RUNS_MERGE_H
#define PLUME_RUNS_MERGE_H

#include <filesystem>
#include <vector>

#include "sandbox/runs/results.h"

namespace plume {

/// Copies the pictures of all parts to `out`, writes results.json and results.csv there, and returns them:
/// frames in the order of the plan. Throws FileError, and std::runtime_error unless the parts are of one
/// plan, measured with the same device, driver and build, and have every job of the plan. Two parts may have
/// the same job when they agree in everything but its times, which are then those of the first.
Results merge(const std::vector<std::filesystem::path>& parts, const std::filesystem::path& out);

}  // namespace plume
#endif
