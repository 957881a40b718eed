#include "sandbox/presets/value_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "sandbox/presets/toml_text.h"

namespace plume {
namespace {

bool is_bare(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

std::string written_key(std::string_view key) {
  return !key.empty() && std::ranges::all_of(key, is_bare) ? std::string(key) : quoted_text(key);
}

std::vector<Step> parse_path(std::string_view path) {
  const auto fail = [&] {
    throw std::invalid_argument(
        fmt::format("`{}` is no path, expected one such as emitter[0].look.lit", path));
  };
  std::vector<Step> steps;
  for (size_t at = 0;;) {
    Step& step = steps.emplace_back();
    const bool is_quoted = at < path.size() && path[at] == '"';
    for (at += is_quoted; at < path.size() && (is_quoted ? path[at] != '"' : is_bare(path[at])); ++at) {
      // quoted_text() writes other escapes for control characters alone, which no key that we write has.
      if (is_quoted && path[at] == '\\' && at + 1 < path.size()) ++at;
      step.key += path[at];
    }
    if (is_quoted && at == path.size()) fail();
    at += is_quoted;
    if (step.key.empty() && !is_quoted) fail();
    if (at < path.size() && path[at] == '[') {
      const char* end = path.data() + path.size();
      const auto [stop, error] = std::from_chars(path.data() + at + 1, end, step.index.emplace());
      if (error != std::errc() || stop == end || *stop != ']') fail();
      at = static_cast<size_t>(stop - path.data()) + 1;
    }
    if (at == path.size()) return steps;
    if (path[at++] != '.') fail();
  }
}

std::string to_string(const std::vector<Step>& steps) {
  std::string path;
  for (const auto& [key, index] : steps) {
    if (!path.empty()) path += '.';
    path += written_key(key);
    if (index) path += fmt::format("[{}]", *index);
  }
  return path;
}

std::string pattern_of(std::string_view path) {
  std::vector<Step> steps = parse_path(path);
  for (Step& step : steps) step.index.reset();
  return to_string(steps);
}

}  // namespace plume
