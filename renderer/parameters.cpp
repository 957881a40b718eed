#include "renderer/parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "renderer/methods/method.h"

namespace plume {
namespace {

/// The double that prints like the float: 0.1f as 0.1, not 0.10000000149.
double shortest(float value) {
  return std::stod(fmt::format("{}", value));
}

class ValueList : public ParameterVisitor {
 public:
  nlohmann::json values = nlohmann::json::object();

  void number(std::string_view name, float& value, const NumberInfo&) override { set(name, shortest(value)); }
  void integer(std::string_view name, int& value, const NumberInfo&) override { set(name, value); }
  void toggle(std::string_view name, bool& value, std::string_view) override { set(name, value); }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view) override {
    set(name, options[static_cast<size_t>(value)]);
  }

 private:
  template <class Value>
  void set(std::string_view name, const Value& value) {
    values[std::string(name)] = value;
  }
};

class TextList : public ParameterVisitor {
 public:
  std::map<std::string, std::string> texts;

  void number(std::string_view name, float& value, const NumberInfo&) override {
    std::string text = fmt::format("{}", value);
    // Texts are read as double and then rounded: for a handful of floats that is not the same.
    if (static_cast<float>(std::stod(text)) != value) text = fmt::format("{}", double(value));
    texts.emplace(name, std::move(text));
  }
  void integer(std::string_view name, int& value, const NumberInfo&) override {
    texts.emplace(name, std::to_string(value));
  }
  void toggle(std::string_view name, bool& value, std::string_view) override {
    texts.emplace(name, value ? "true" : "false");
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view) override {
    texts.emplace(name, options[static_cast<size_t>(value)]);
  }
};

class Description : public ParameterVisitor {
 public:
  nlohmann::json list = nlohmann::json::array();

  void number(std::string_view name, float& value, const NumberInfo& info) override {
    list.push_back({{"name", name},
                    {"type", "number"},
                    {"min", info.min},
                    {"max", info.max},
                    {"unit", info.unit},
                    {"help", info.help},
                    {"value", shortest(value)}});
  }
  void integer(std::string_view name, int& value, const NumberInfo& info) override {
    list.push_back({{"name", name},
                    {"type", "integer"},
                    {"min", std::llround(info.min)},
                    {"max", std::llround(info.max)},
                    {"unit", info.unit},
                    {"help", info.help},
                    {"value", value}});
  }
  void toggle(std::string_view name, bool& value, std::string_view help) override {
    list.push_back({{"name", name}, {"type", "toggle"}, {"help", help}, {"value", value}});
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view help) override {
    list.push_back({{"name", name},
                    {"type", "choice"},
                    {"options", options},
                    {"help", help},
                    {"value", options[static_cast<size_t>(value)]}});
  }
  void modes(std::string_view name, int& value, std::span<const Mode> modes, std::string_view help) override {
    ParameterVisitor::modes(name, value, modes, help);
    auto& helps = list.back()["option_help"];
    for (const Mode& mode : modes) helps.push_back(mode.help);
  }
};

/// The whole of `text` as a number; nothing when it is not one.
template <class Value>
std::optional<Value> parsed(std::string_view text) {
  Value value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return {};
  return value;
}

class Setter : public ParameterVisitor {
 public:
  Setter(std::string_view name, std::string_view text) : name_(name), text_(text) {}
  bool found = false;
  std::vector<std::string> names;

  void number(std::string_view name, float& value, const NumberInfo& info) override {
    if (!matches(name)) return;
    const auto number = parsed<double>(text_);
    // Written so that NaN fails too.
    if (!number || !(*number >= info.min && *number <= info.max)) fail("a number " + range(info));
    value = static_cast<float>(*number);
  }
  void integer(std::string_view name, int& value, const NumberInfo& info) override {
    if (!matches(name)) return;
    const auto number = parsed<int64_t>(text_);
    if (!number || static_cast<double>(*number) < info.min || static_cast<double>(*number) > info.max)
      fail("a whole number " + range(info));
    value = static_cast<int>(*number);
  }
  void toggle(std::string_view name, bool& value, std::string_view) override {
    if (!matches(name)) return;
    if (text_ != "true" && text_ != "false") fail("true or false");
    value = text_ == "true";
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view) override {
    if (!matches(name)) return;
    const auto option = std::ranges::find(options, text_);
    if (option == options.end()) fail(fmt::format("one of {}", fmt::join(options, ", ")));
    value = static_cast<int>(option - options.begin());
  }

 private:
  bool matches(std::string_view name) {
    names.emplace_back(name);
    found |= name == name_;
    return name == name_;
  }
  static std::string range(const NumberInfo& info) {
    return fmt::format("from {} to {}{}{}", info.min, info.max, info.unit.empty() ? "" : " ", info.unit);
  }
  [[noreturn]] void fail(const std::string& expected) const {
    throw ParameterError(fmt::format("`{}` is {}, expected {}", name_, text_, expected));
  }

  std::string_view name_, text_;
};

/// Optimal string alignment: Levenshtein with swaps of neighbours.
size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<size_t> before, above(b.size() + 1), row(b.size() + 1);
  for (size_t j = 0; j <= b.size(); ++j) above[j] = j;
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = above;
    above = row;
  }
  return above[b.size()];
}

}  // namespace

nlohmann::json parameter_values(Method& method) {
  ValueList visitor;
  method.visit(visitor);
  return visitor.values;
}

std::map<std::string, std::string> parameter_texts(Method& method) {
  TextList visitor;
  method.visit(visitor);
  return std::move(visitor.texts);
}

nlohmann::json parameter_list(Method& method) {
  Description visitor;
  method.visit(visitor);
  return visitor.list;
}

void set_parameter(Method& method, std::string_view name, std::string_view value) {
  Setter setter(name, value);
  method.visit(setter);
  if (setter.found) return;
  throw ParameterError(
      fmt::format("unknown parameter `{}` of {}, {}", name, method.id(), suggestion(name, setter.names)));
}

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
  std::string best;
  size_t best_distance = SIZE_MAX;
  for (const std::string& candidate : candidates) {
    const size_t longer = std::max(word.size(), candidate.size());
    const size_t shorter = std::min(word.size(), candidate.size());
    if (longer - shorter > longer / 2)
      continue;  // that many insertions alone; also bounds the work on huge words
    const size_t distance = edit_distance(word, candidate);
    if (distance > longer / 2 || distance >= best_distance) continue;
    best = candidate;
    best_distance = distance;
  }
  return best;
}

std::string suggestion(std::string_view word, std::span<const std::string> candidates) {
  const std::string near = nearest(word, candidates);
  if (!near.empty()) return fmt::format("did you mean `{}`?", near);
  if (candidates.empty()) return "expected none: there is none to choose from";
  return fmt::format("expected one of `{}`", fmt::join(candidates, "`, `"));
}

}  // namespace plume
