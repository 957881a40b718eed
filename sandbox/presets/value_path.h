// The place of a value in a preset file, counted from the top: emitter[2].motion.curl.strength. Keys that are
// not bare stand in quotes, as in TOML: instance[0].layers."far away".
#ifndef PLUME_PRESETS_VALUE_PATH_H
#define PLUME_PRESETS_VALUE_PATH_H

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace plume {

struct Step {
  std::string key;
  std::optional<size_t> index = {};  ///< into the list at that key
};

/// Throws std::invalid_argument when `path` is none.
std::vector<Step> parse_path(std::string_view path);
std::string to_string(const std::vector<Step>& steps);
/// As it is written in a path and in a file: bare where that is enough.
std::string written_key(std::string_view key);
/// The path without the places in lists: emitter.motion.curl.strength.
std::string pattern_of(std::string_view path);

}  // namespace plume
#endif
