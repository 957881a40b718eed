// A value as it is written in a file, so that it reads back exactly: numbers with the fewest digits that do.
#ifndef PLUME_PRESETS_TOML_TEXT_H
#define PLUME_PRESETS_TOML_TEXT_H

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace plume {

/// A number, a toggle, a text, a list of values, or text in TOML that stands for itself.
struct TomlValue {
  struct Verbatim {
    std::string text;
  };
  std::variant<bool, int64_t, float, double, std::string, std::vector<TomlValue>, Verbatim> value;
};

std::string to_toml(const TomlValue& value);
/// In double quotes, with escapes.
std::string quoted_text(std::string_view text);

}  // namespace plume
#endif
