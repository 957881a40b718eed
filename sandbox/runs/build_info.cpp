#include "sandbox/runs/build_info.h"

#include "build_commit.h"  // written by the build, see cmake/build_commit.cmake

namespace plume {

std::string build_name() {
#ifdef __clang__
  const std::string compiler = "clang " __clang_version__;
#else
  const std::string compiler = "g++ " __VERSION__;
#endif
  return PLUME_VERSION " " PLUME_BUILD_TYPE ", " + compiler;
}

std::string build_commit() {
  return PLUME_BUILD_COMMIT;
}

}  // namespace plume
