#include "sandbox/commands/user_folders.h"

#include <cstdlib>
#include <string_view>

namespace plume {
namespace fs = std::filesystem;
namespace {

/// The variable where it is set to something.
const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value && *value ? value : nullptr;
}

std::optional<fs::path> user_folder(const char* own, const char* desktop, const char* in_home) {
  if (const char* chosen = variable(own))
    return std::string_view(chosen) == "off" ? std::nullopt : std::optional<fs::path>(chosen);
  // The specification: a path that is not absolute is ignored.
  if (const char* base = variable(desktop); base && fs::path(base).is_absolute())
    return fs::path(base) / "plume";
  if (const char* home = variable("HOME"); home && fs::path(home).is_absolute())
    return fs::path(home) / in_home / "plume";
  return std::nullopt;
}

}  // namespace

std::optional<fs::path> cache_folder() {
  return user_folder("PLUME_CACHE", "XDG_CACHE_HOME", ".cache");
}
std::optional<fs::path> config_folder() {
  return user_folder("PLUME_CONFIG", "XDG_CONFIG_HOME", ".config");
}

}  // namespace plume
