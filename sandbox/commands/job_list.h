// --list: the jobs that a run would draw.
#ifndef PLUME_COMMANDS_JOB_LIST_H
#define PLUME_COMMANDS_JOB_LIST_H

#include "sandbox/runs/selection.h"

namespace plume {

/// A table whose first column is the id.
std::string job_table(const Plan& plan, const Selection& selection);
/// {"command", "plan": {"id", "jobs"}, "jobs": [{"job", "scene", "tick", "shot", "size", "seed", "method",
/// "settings"}]}, where settings are those that are not the defaults.
nlohmann::json job_list(const Plan& plan, const Selection& selection, const std::string& command);

}  // namespace plume
#endif
