#include "tests/property/random_value.h"

#include <algorithm>
#include <map>
#include <type_traits>

namespace plume {
namespace {

/// What is neither small nor large, by unit.
double usual(std::string_view unit) {
  static const std::map<std::string_view, double> kUsual = {
      {"ticks", 60},   {"particles", 16}, {"particles a second", 30}, {"m/s", 2}, {"m/s^2", 3},
      {"degrees", 30}, {"mm", 20},        {"degrees a second", 90}};
  const auto found = kUsual.find(unit);
  return found == kUsual.end() ? 1.0 : found->second;
}

class Draw {
 public:
  Draw(const Field& field, Dice& dice, uint32_t wildness) : field_(field), dice_(dice), wildness_(wildness) {}

  double number(const Limits& limits, bool whole, double about = 0.0) {
    const double largest = std::max(std::abs(limits.min), std::abs(limits.max));
    double value;
    if (dice_.chance(wildness_)) {
      value = dice_.chance(50) ? limits.min : limits.max;
    } else if (dice_.chance(wildness_)) {
      value = dice_.octaves(-8, std::max(std::ilogb(largest), -8));
    } else {
      value = (about != 0 ? std::abs(about) : usual(limits.unit)) * dice_.octaves(-2, 0);
    }
    if (value > 0 && limits.min < 0 && dice_.chance(about < 0 ? 75 : 25)) value = -value;
    if (whole) value = std::round(value);
    return std::clamp(value, limits.min, limits.max);
  }
  template <class Number>
  Number number(Number about) {
    return static_cast<Number>(number(field_.limits, std::is_integral_v<Number>, double(about)));
  }
  template <class Number>
  Range<Number> range(const Range<Number>& about) {
    const Number a = number(about.min), b = number(about.max);
    return {std::min(a, b), std::max(a, b)};
  }
  glm::vec3 vector(const Limits& limits, const glm::vec3& about = glm::vec3(0.0f)) {
    glm::vec3 v;
    for (int i = 0; i < 3; ++i) v[i] = float(number(limits, false, double(about[i])));
    return v;
  }

  /// Of a life: from 0 or later, ascending.
  std::vector<float> places() {
    std::vector<float> places{dice_.chance(75) ? 0.0f : 0.125f};
    while (places.size() < 4 && dice_.chance(50))
      places.push_back(places.back() + float(1 + dice_.below(16)) / 64.0f);
    return places;
  }
  Curve curve() {
    std::vector<Curve::Key> keys;
    for (const float at : places()) {
      keys.push_back({.at = at, .value = number(1.0f)});
      // Level, so that it swings over no limit.
      if (dice_.chance(25)) keys.back().in = keys.back().out = 0.0f;
    }
    return keys;
  }
  Gradient gradient() {
    std::vector<Gradient::Key> keys;
    for (const float at : places()) keys.push_back({at, vector(field_.limits)});
    return keys;
  }
  /// Those of the first column, ascending, as many as the field takes and few.
  std::vector<double> column() {
    const Column& first = field_.columns[0];
    std::vector<double> at;
    for (size_t i = 0; i < field_.at_least + dice_.below(3) + 1; ++i)
      at.push_back(number(first.limits, first.whole));
    std::ranges::sort(at);
    at.erase(std::ranges::unique(at).begin(), at.end());
    return at;
  }
  Pairs pairs() {
    Pairs rows;
    for (const double at : column())
      rows.push_back({at, number(field_.columns[1].limits, field_.columns[1].whole)});
    return rows;
  }
  Points points() {
    Points rows;
    for (const double at : column()) rows.emplace_back(at, vector(field_.columns[1].limits));
    return rows;
  }
  std::string text() {
    if (!field_.options.empty()) return dice_.one_of(field_.options);
    static const std::vector<std::string> kTexts = {
        "a", "two words", "Rauch über \"Glas\"", "煙", "back\\slash", "tab\there", "a.b[0]", "#1", "'"};
    return dice_.one_of(kTexts);
  }
  Texts texts() {
    Texts some{text()};
    while (some.size() < std::min<size_t>(field_.at_most, 3) && dice_.chance(50)) some.push_back(text());
    return some;
  }

  FieldValue value() {
    if (field_.takes(Pairs{}) && dice_.chance(50)) return pairs();
    return std::visit(
        [&](const auto& now) -> FieldValue {
          using T = std::decay_t<decltype(now)>;
          if constexpr (std::is_same_v<T, bool>)
            return dice_.chance(50);
          else if constexpr (std::is_same_v<T, std::string>)
            return text();
          else if constexpr (std::is_same_v<T, Texts>)
            return texts();
          else if constexpr (std::is_same_v<T, glm::vec2>)
            return glm::vec2(vector(field_.limits, glm::vec3(now, 0.0f)));
          else if constexpr (std::is_same_v<T, glm::vec3>)
            return vector(field_.limits, now);
          else if constexpr (std::is_same_v<T, Range<float>> || std::is_same_v<T, Range<uint32_t>>)
            return range(now);
          else if constexpr (std::is_same_v<T, Curve>)
            return curve();
          else if constexpr (std::is_same_v<T, Gradient>)
            return gradient();
          else if constexpr (std::is_same_v<T, Pairs>)
            return pairs();
          else if constexpr (std::is_same_v<T, Points>)
            return points();
          else if constexpr (std::is_arithmetic_v<T>)
            return number(now);
          else  // what no effect and no scene has, and tables
            throw std::invalid_argument("no random value for `" + field_.path + "`");
        },
        field_.value);
  }

 private:
  const Field& field_;
  Dice& dice_;
  uint32_t wildness_;
};

}  // namespace

FieldValue random_value(const Field& field, Dice& dice, uint32_t wildness) {
  return Draw(field, dice, wildness).value();
}

}  // namespace plume
