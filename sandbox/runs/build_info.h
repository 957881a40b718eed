// Which build made a result.
#ifndef PLUME_RUNS_BUILD_INFO_H
#define PLUME_RUNS_BUILD_INFO_H

#include <string>

namespace plume {

/// Version, build type and compiler.
std::string build_name();
/// Short hash of the commit, "+" when the tree had changes; "unknown" outside a git checkout.
std::string build_commit();

}  // namespace plume
#endif
