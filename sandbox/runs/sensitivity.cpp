#include "sandbox/runs/sensitivity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "renderer/methods/methods.h"

namespace plume {
namespace {

using nlohmann::json;
using Kind = ParameterChange::Kind;

/// Every place that a number between its limits is moved to.
std::vector<double> moved(double value, double min, double max, bool whole) {
  std::vector<double> places;
  if (whole && max - min <= 8.0)
    places = {value - 1.0, value + 1.0};
  else if (value == 0.0 && whole)
    places = {-1.0, 1.0};
  else if (value == 0.0)
    places = {min / 10.0, max / 10.0};
  else
    places = {value / 2.0, value * 2.0};
  std::vector<double> moved;
  for (double place : places) {
    place = std::clamp(whole ? std::trunc(place) : place, min, max);
    if (place != value && std::ranges::find(moved, place) == moved.end()) moved.push_back(place);
  }
  return moved;
}

/// A visit that notes where each parameter can be moved, and moves none.
class Moves : public ParameterVisitor {
 public:
  std::vector<std::pair<std::string, std::string>> list;

  void number(std::string_view name, float& value, const NumberInfo& info) override {
    for (const double place : moved(double(value), info.min, info.max, false))
      list.emplace_back(name, fmt::format("{}", float(place)));
  }
  void integer(std::string_view name, int& value, const NumberInfo& info) override {
    for (const double place : moved(value, info.min, info.max, true))
      list.emplace_back(name, fmt::format("{}", int64_t(place)));
  }
  void toggle(std::string_view name, bool& value, std::string_view) override {
    list.emplace_back(name, value ? "false" : "true");
  }
  void choice(std::string_view name, int& value, std::span<const std::string_view> options,
              std::string_view) override {
    for (size_t i = 0; i < options.size(); ++i)
      if (i != size_t(value)) list.emplace_back(name, options[i]);
  }
};

/// The one parameter that they differ in.
std::optional<std::string> parameter_moved(const FrameResult& a, const FrameResult& b) {
  std::optional<std::string> name;
  for (const auto& [key, value] : a.settings.items()) {
    if (b.settings.value(key, json()) == value) continue;
    if (name) return std::nullopt;
    name = key;
  }
  return name;
}

bool same_contest(const FrameResult& a, const FrameResult& b) {
  return a.method == b.method && a.scene == b.scene && a.tick == b.tick && a.shot == b.shot &&
         a.seed == b.seed && a.width == b.width && a.height == b.height;
}

/// Among changes of one kind: the more, the better.
double merit(const ParameterChange& change) {
  switch (change.kind()) {
    case Kind::kFree:
      return change.error_lost();
    case Kind::kBuys:
      return *change.accuracy_per_ms();
    case Kind::kSaves:
      return -*change.accuracy_per_ms();
    default:
      return 0.0;
  }
}

std::string text_of(const json& value) {
  return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string line_of(const ParameterChange& c) {
  const double before = c.unchanged.error->rmse, after = c.changed.error->rmse;
  std::string line =
      fmt::format("  {:<6} {:<38} RMSE {:.5f} -> {:.5f}  own ms {:.2f} -> {:.2f}",
                  kParameterChangeKinds[size_t(c.kind())],
                  fmt::format("{} {} -> {}", c.parameter, text_of(c.unchanged.settings[c.parameter]),
                              text_of(c.changed.settings[c.parameter])),
                  before, after, c.unchanged.transparency_ms.median, c.changed.transparency_ms.median);
  if (const auto rate = c.accuracy_per_ms(); rate && *rate > 0.0)
    line += fmt::format("  {} {:.3g} RMSE a ms", c.kind() == Kind::kBuys ? "buys" : "costs", *rate);
  return line + (c.sure() ? "\n" : "  (not sure)\n");
}

}  // namespace

std::vector<std::pair<std::string, std::string>> moved_parameters(Method& method) {
  Moves moves;
  method.visit(moves);
  return std::move(moves.list);
}

void add_moved_parameters(Replay& replay) {
  std::vector<MethodRun> runs;
  for (const MethodRun& run : replay.methods) {
    runs.push_back(run);
    const auto method = make_method(run.id);
    for (const auto& [name, value] : run.settings) set_parameter(*method, name, value);
    for (const auto& [name, value] : moved_parameters(*method)) {
      runs.push_back(run);
      runs.back().settings[name] = value;
    }
  }
  replay.methods = std::move(runs);
}

bool ParameterChange::error_moves() const {
  const double before = unchanged.error->rmse, after = changed.error->rmse;
  if (!std::isfinite(before) || !std::isfinite(after)) return std::isfinite(before) != std::isfinite(after);
  return std::abs(before - after) > std::max(kErrorNoise * std::max(before, after), 1e-6);
}

Kind ParameterChange::kind() const {
  if (!error_moves()) {
    if (!time_moves()) return Kind::kNothing;
    return ms_added() < 0.0 ? Kind::kSaves : Kind::kWorse;
  }
  if (error_lost() > 0.0) return ms_added() > 0.0 ? Kind::kBuys : Kind::kFree;
  return ms_added() < 0.0 ? Kind::kSaves : Kind::kWorse;
}

bool ParameterChange::sure() const {
  switch (kind()) {
    case Kind::kNothing:
      return false;
    case Kind::kWorse:  // it gains nothing, whatever the other side is
      return error_moves() || time_moves();
    case Kind::kSaves:
      return time_moves();
    default:
      return error_moves() && time_moves();
  }
}

std::optional<double> ParameterChange::accuracy_per_ms() const {
  if (kind() == Kind::kBuys) return error_lost() / ms_added();
  if (kind() == Kind::kSaves) return error_moves() ? error_lost() / ms_added() : 0.0;
  return std::nullopt;
}

std::vector<ParameterChange> parameter_changes(const Results& results) {
  std::vector<ParameterChange> all;
  std::vector<const FrameResult*> unchanged;
  for (const FrameResult& frame : results.frames) {
    if (frame.status != "ok" || !frame.error) continue;
    const auto first =
        std::ranges::find_if(unchanged, [&](const FrameResult* f) { return same_contest(*f, frame); });
    if (first == unchanged.end())
      unchanged.push_back(&frame);
    else if (const auto parameter = parameter_moved(**first, frame))
      all.push_back({**first, frame, *parameter});
  }
  return all;
}

std::vector<ParameterChange> best_first(std::vector<ParameterChange> changes) {
  std::vector<const FrameResult*> methods;  // in their order
  const auto place = [&](const ParameterChange& c) {
    return std::ranges::find_if(methods,
                                [&](const FrameResult* f) { return same_contest(*f, c.unchanged); }) -
           methods.begin();
  };
  std::vector<std::pair<ptrdiff_t, ParameterChange>> placed;
  for (const ParameterChange& c : changes) {
    if (place(c) == std::ssize(methods)) methods.push_back(&c.unchanged);
    placed.emplace_back(place(c), c);
  }
  std::ranges::stable_sort(placed, std::less(), [](const auto& p) {
    const ParameterChange& c = p.second;
    return std::tuple(p.first, c.kind(), !c.sure(), -merit(c));
  });
  std::vector<ParameterChange> sorted;
  for (auto& [method, change] : placed) sorted.push_back(std::move(change));
  return sorted;
}

json to_json(const std::vector<ParameterChange>& changes) {
  json list = json::array();
  const auto or_null = [](double value) { return std::isfinite(value) ? json(value) : json(nullptr); };
  for (const ParameterChange& c : changes) {
    const FrameResult& f = c.unchanged;
    const auto rate = c.accuracy_per_ms();
    list.push_back({{"scene", f.scene},
                    {"tick", f.tick},
                    {"size", {f.width, f.height}},
                    {"seed", f.seed},
                    {"method", f.method},
                    {"parameter", c.parameter},
                    {"from", f.settings[c.parameter]},
                    {"to", c.changed.settings[c.parameter]},
                    {"error_before", or_null(f.error->rmse)},
                    {"error_after", or_null(c.changed.error->rmse)},
                    {"ms_before", f.transparency_ms.median},
                    {"ms_after", c.changed.transparency_ms.median},
                    {"accuracy_per_ms", rate ? or_null(*rate) : json(nullptr)},
                    {"kind", kParameterChangeKinds[size_t(c.kind())]},
                    {"sure", c.sure()}});
  }
  return list;
}

std::string to_table(const std::vector<ParameterChange>& all) {
  const std::vector<ParameterChange> changes = best_first(all);
  std::string table;
  for (size_t begin = 0, end = 0; begin < changes.size(); begin = end) {
    const FrameResult& method = changes[begin].unchanged;
    while (end < changes.size() && same_contest(changes[end].unchanged, method)) ++end;
    const auto of_method = std::span(changes).subspan(begin, end - begin);
    table += fmt::format("{} on {} tick {}, RMSE {:.5f} in {:.2f} ms: ", method.method, method.scene,
                         method.tick, method.error->rmse, method.transparency_ms.median);
    const auto best = std::ranges::find_if(
        of_method, [](const ParameterChange& c) { return c.kind() == Kind::kBuys && c.sure(); });
    table += best == of_method.end()
                 ? std::string("no parameter buys accuracy for certain\n")
                 : fmt::format("{} buys most accuracy per millisecond\n", best->parameter);
    std::vector<std::string> worse, nothing;
    for (const ParameterChange& c : of_method) {
      const std::string name = fmt::format("{}={}", c.parameter, text_of(c.changed.settings[c.parameter]));
      if (c.kind() == Kind::kWorse)
        worse.push_back(name);
      else if (c.kind() == Kind::kNothing)
        nothing.push_back(name);
      else
        table += line_of(c);
    }
    if (!worse.empty()) table += fmt::format("  gains neither: {}\n", fmt::join(worse, ", "));
    if (!nothing.empty()) table += fmt::format("  no difference to be told: {}\n", fmt::join(nothing, ", "));
  }
  return table;
}

}  // namespace plume
