#include "sandbox/presets/toml_text.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <type_traits>

namespace plume {
namespace {

/// Without exponent where that stays short: people read it.
template <class Real>
std::string shortest(Real number) {
  const Real size = std::abs(number);
  const bool plain = size == 0 || (size >= Real(1e-5) && size < Real(1e9));
  char text[64];
  const auto [end, error] = std::to_chars(text, text + sizeof text, number,
                                          plain ? std::chars_format::fixed : std::chars_format::scientific);
  std::string written(text, end);
  // Files are read as double and then rounded: for a handful of floats that is not the same.
  if (static_cast<Real>(std::strtod(written.c_str(), nullptr)) != number)
    written = fmt::format("{:.{}e}", number, std::numeric_limits<double>::max_digits10 - 1);
  // 2.0 shows that the number need not be whole.
  return written.find_first_of(".e") == written.npos ? written + ".0" : written;
}

}  // namespace

std::string quoted_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += {'\\', c};
    else if (c == '\n')
      result += "\\n";
    else if (c == '\t')
      result += "\\t";
    else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F)
      result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    else
      result += c;
  }
  return result + '"';
}

std::string to_toml(const TomlValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, bool>) {
          return v ? "true" : "false";
        } else if constexpr (std::is_same_v<T, int64_t>) {
          return fmt::format("{}", v);
        } else if constexpr (std::is_floating_point_v<T>) {
          return shortest(v);
        } else if constexpr (std::is_same_v<T, std::string>) {
          return quoted_text(v);
        } else if constexpr (std::is_same_v<T, TomlValue::Verbatim>) {
          return v.text;
        } else {
          std::string list;
          for (const TomlValue& item : v) list += (list.empty() ? "" : ", ") + to_toml(item);
          return "[" + list + "]";
        }
      },
      value.value);
}

}  // namespace plume
