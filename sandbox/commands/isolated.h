// --isolate: each job in a process of its own, so that a lost device or a crash costs that job alone.
#ifndef PLUME_COMMANDS_ISOLATED_H
#define PLUME_COMMANDS_ISOLATED_H

#include <string>
#include <vector>

#include "sandbox/runs/measurement.h"

namespace plume {

struct IsolatedRun {
  size_t failed = 0;      ///< jobs that failed twice; the manifest says why
  bool messages = false;  ///< from the validation layer, which are handed on
};

/// As measure(), by running this program with `arguments` for each job. A job that fails is tried once more.
/// Throws gpu::NoUsableDevice when there is none for any.
IsolatedRun measure_isolated(const Plan& plan, const MeasurementOptions& options,
                             const std::vector<std::string>& arguments, Manifest& manifest);

}  // namespace plume
#endif
