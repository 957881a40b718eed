// Which build made a result.
#ifndef PLUME_MEASURE_BUILD_INFO_H
#define PLUME_MEASURE_BUILD_INFO_H

#include <string>

namespace plume {

/// Version, build type and compiler.
std::string build_name();
/// Short hash of the commit, "+" when the tree had changes; "unknown" outside a git checkout.
std::string build_commit();

}  // namespace plume
#endif
