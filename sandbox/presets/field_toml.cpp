#include "sandbox/presets/field_toml.h"

#include <fmt/format.h>

#include <initializer_list>
#include <stdexcept>
#include <type_traits>

namespace plume {
namespace {

using List = std::vector<TomlValue>;

template <class... Values>
TomlValue list_of(const Values&... values) {
  return {List{TomlValue{values}...}};
}

template <class Item, class ToToml>
TomlValue list_of_each(const std::vector<Item>& items, const ToToml& to_toml) {
  List list;
  for (const Item& item : items) list.push_back(to_toml(item));
  return {std::move(list)};
}

TomlValue list_of(const glm::vec3& v) {
  return list_of(v.x, v.y, v.z);
}

TomlValue number(double value, const Column& column) {
  return column.whole ? TomlValue{static_cast<int64_t>(value)} : TomlValue{value};
}

/// Of the chord between two keys: what a side without a slope has.
float chord(const Curve::Key& a, const Curve::Key& b) {
  return (b.value - a.value) / (b.at - a.at);
}

TomlValue rows_of(const Curve& curve) {
  List rows;
  for (size_t i = 0; i < curve.keys.size(); ++i) {
    const Curve::Key& key = curve.keys[i];
    List row{{key.at}, {key.value}};
    if (key.in || key.out) {
      // A file says both or none.
      const float in = key.in ? *key.in : i > 0 ? chord(curve.keys[i - 1], key) : *key.out;
      const float out = key.out ? *key.out : i + 1 < curve.keys.size() ? chord(key, curve.keys[i + 1]) : in;
      row.push_back({in});
      if (out != in) row.push_back({out});
    }
    rows.push_back({std::move(row)});
  }
  return {std::move(rows)};
}

template <class Keys>
bool is_constant(const Keys& keys) {
  return keys.size() == 1 && keys[0].at == 0;
}

}  // namespace

TomlValue to_toml_value(const Field& field, const FieldValue& value, size_t nesting) {
  if (!field.takes(value))
    throw std::invalid_argument(fmt::format("a value of another type than `{}` takes", field.path));
  return std::visit(
      [&](const auto& v) -> TomlValue {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, Group> || std::is_same_v<T, Groups>) {
          throw std::invalid_argument(fmt::format("`{}` is no value", field.path));
        } else if constexpr (std::is_same_v<T, Texts>) {
          if (v.size() == 1 && nesting == 0) return {v[0]};
          return list_of_each(v, [](const std::string& text) { return TomlValue{text}; });
        } else if constexpr (std::is_same_v<T, glm::vec2>) {
          return list_of(v.x, v.y);
        } else if constexpr (std::is_same_v<T, glm::vec3>) {
          return list_of(v);
        } else if constexpr (std::is_same_v<T, glm::uvec2>) {
          return list_of(int64_t(v.x), int64_t(v.y));
        } else if constexpr (std::is_same_v<T, Range<float>>) {
          return v.min == v.max && nesting == 0 ? TomlValue{v.min} : list_of(v.min, v.max);
        } else if constexpr (std::is_same_v<T, Range<uint32_t>>) {
          return v.min == v.max && nesting == 0 ? TomlValue{int64_t(v.min)}
                                                : list_of(int64_t(v.min), int64_t(v.max));
        } else if constexpr (std::is_same_v<T, Curve>) {
          const bool plain = is_constant(v.keys) && !v.keys[0].in && !v.keys[0].out;
          return plain && nesting == 0 ? TomlValue{v.keys[0].value} : rows_of(v);
        } else if constexpr (std::is_same_v<T, Gradient>) {
          if (is_constant(v.keys) && nesting < 2) return list_of(v.keys[0].value);
          return list_of_each(v.keys, [](const Gradient::Key& key) {
            return TomlValue{List{{key.at}, list_of(key.value)}};
          });
        } else if constexpr (std::is_same_v<T, Wholes>) {
          return list_of_each(v, [](uint32_t whole) { return TomlValue{int64_t(whole)}; });
        } else if constexpr (std::is_same_v<T, Pairs>) {
          return list_of_each(v, [&](const std::array<double, 2>& pair) {
            return TomlValue{List{number(pair[0], field.columns[0]), number(pair[1], field.columns[1])}};
          });
        } else if constexpr (std::is_same_v<T, Points>) {
          return list_of_each(v, [&](const std::pair<double, glm::vec3>& point) {
            return TomlValue{List{number(point.first, field.columns[0]), list_of(point.second)}};
          });
        } else {
          return {v};
        }
      },
      value);
}

}  // namespace plume
