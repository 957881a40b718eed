// What can be written in a preset file: every key that its reader asks for, as the reader asks for it. A
// reader that is given a list of fields (see TableReader) notes there what it does anyway, so limits,
// defaults and conditions ("only a cone has an angle") are stated in the readers alone, and an editor made
// from the list lacks no key.
#ifndef PLUME_PRESETS_FIELD_H
#define PLUME_PRESETS_FIELD_H

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "sandbox/effects/curve.h"
#include "sandbox/effects/effect.h"

namespace plume {

/// Inclusive limits of a number and its unit ("" where it has none).
struct Limits {
  double min, max;
  std::string_view unit = "";
};

constexpr Limits kTick{0, kMaxTick, "ticks"};
/// Of each side of a picture.
constexpr Limits kPixels{1, 16'384, "pixels"};
/// Of what artists order by hand.
constexpr Limits kDrawOrder{-1000, 1000};
constexpr Limits kCameraOffset{-100, 100, "m"};
/// Of a curve, at its keys.
constexpr Limits kSlope{-1e6, 1e6, "a life"};

enum class Need { kOptional, kRequired };

/// One column of a list of pairs, such as the tick and the count of a burst.
struct Column {
  std::string_view name;
  Limits limits;
  bool whole = false;  ///< integers only
};

/// A table.
struct Group {
  bool operator==(const Group&) const = default;
};
/// A list of tables.
struct Groups {
  size_t count = 0;
  bool operator==(const Groups&) const = default;
};
using Texts = std::vector<std::string>;
using Wholes = std::vector<uint32_t>;
using Pairs = std::vector<std::array<double, 2>>;
using Points = std::vector<std::pair<double, glm::vec3>>;

/// The type tells the kind of a field: a toggle, a number (float, double), an integer, a text or a choice of
/// texts, texts (meshes), a vector, a range, a curve, a gradient, …
using FieldValue =
    std::variant<bool, float, double, int64_t, std::string, Texts, glm::vec2, glm::vec3, glm::uvec2,
                 Range<float>, Range<uint32_t>, Curve, Gradient, Wholes, Pairs, Points, Group, Groups>;

struct Field {
  enum class State { kAbsent, kRead, kWrong };

  std::string path;     ///< from the top, such as emitter[2].motion.curl.strength
  FieldValue value;     ///< as read; `fallback` where it is absent or wrong
  FieldValue fallback;  ///< what holds when the file does not say
  State state = State::kAbsent;
  bool required = false;  ///< in its table
  bool in_absent_table = false;
  Limits limits{};              ///< of each number in `value`; of a curve's or a gradient's values
  std::vector<Column> columns;  ///< of Pairs and Points, instead of `limits`; a field that has both takes a
                                ///< number (double) as well as Pairs
  size_t at_least = 0, at_most = 0;  ///< entries in a list
  std::vector<std::string> options;  ///< of a text: it is one of these, if there are any
  std::string names;                 ///< of a text that names something: the pattern of the field that it
                                     ///< repeats ("layer.name"), or "mesh", "effect"
  std::vector<std::string> rivals;   ///< paths of fields that cannot stand beside it

  bool present() const { return state != State::kAbsent; }
  /// Whether a value is of a type that the field takes.
  bool takes(const FieldValue& other) const {
    const auto is_either = [](const FieldValue& v) {
      return std::holds_alternative<double>(v) || std::holds_alternative<Pairs>(v);
    };
    const bool both = limits.max > limits.min && !columns.empty();
    return other.index() == value.index() || (both && is_either(other) && is_either(value));
  }
};

}  // namespace plume
#endif
