#include "sandbox/presets/read_sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <set>
#include <tuple>

#include "renderer/methods/methods.h"
#include "renderer/parameters.h"
#include "sandbox/presets/printable.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/read_ticks.h"

namespace plume {
namespace {

constexpr size_t kMaxSweeps = 1'000, kMaxScenes = 1'000, kMaxSizes = 1'000, kMaxSpans = 1'000;
constexpr uint32_t kMaxJobs = 100'000;
constexpr Limits kSeed{0, UINT32_MAX};

/// The value as the method has it, so that 1 and 1.0 are the same; null when it does not take it. `said`: the
/// mistake before, since that a parameter is not known is said once for all of its values.
nlohmann::json taken(Method& method, const Setting& setting, TableReader& table, std::string& said) try {
  set_parameter(method, setting.key, setting.value);
  return parameter_values(method).at(setting.key);
} catch (const ParameterError& error) {
  if (said != error.what()) table.report(setting.position, error.what());
  said = error.what();
  return nullptr;
}

MethodSpan read_span(TableReader& table) {
  MethodSpan span;
  const bool named = table.text("id", span.id, Need::kRequired);
  const std::vector<Setting> settings = table.settings(TableReader::Values::kSeveral);
  if (!named) return span;
  const std::unique_ptr<Method> method = make_method(span.id);
  if (!method) {
    table.report("id", fmt::format("unknown method `{}`, {}", span.id, suggestion(span.id, method_ids())));
    return span;
  }
  std::set<std::pair<std::string, nlohmann::json>> known;
  std::string said;
  for (const Setting& setting : settings) {
    const nlohmann::json value = taken(*method, setting, table, said);
    if (value.is_null()) continue;
    if (!known.insert({setting.key, value}).second)
      table.report(setting.position, fmt::format("`{}` is {} twice, expected each value once", setting.key,
                                                 printable(setting.value)));
    span.settings[setting.key].push_back(setting.value);
  }
  return span;
}

Sweep read_sweep(TableReader& table) {
  Sweep sweep;
  const auto place = [&](std::string_view key) {
    const toml::source_position at = table.position(key);
    return FilePosition{table.file(), at.line, at.column};
  };
  sweep.at = place("");
  table.texts("scenes", sweep.scenes, kMaxScenes, Need::kRequired);
  sweep.scenes_at = place("scenes");
  read_ticks(table, sweep.ticks, Need::kOptional, kMaxJobs);
  table.sizes("sizes", sweep.sizes, kMaxSizes, kPixels);
  table.ascending("seeds", sweep.seeds, kSeed, 1);
  table.tables(
      "method", kMaxSpans, [&](TableReader& method) { sweep.methods.push_back(read_span(method)); },
      Need::kRequired);
  return sweep;
}

/// What tells jobs of one file apart.
using Key = std::tuple<std::string, std::vector<uint32_t>, std::string, std::map<std::string, std::string>>;

std::vector<Key> keys_of(const Replay& replay) {
  std::vector<uint32_t> place{replay.size.x, replay.size.y};
  if (replay.seed) place.push_back(*replay.seed);
  std::vector<Key> keys;
  for (const MethodRun& run : replay.methods) {
    if (replay.ticks.empty()) keys.emplace_back(replay.scene, place, run.id, run.settings);
    for (const uint32_t tick : replay.ticks) {
      std::vector<uint32_t> at = place;
      at.insert(at.begin(), tick);
      keys.emplace_back(replay.scene, at, run.id, run.settings);
    }
  }
  return keys;
}

void report_repeated(TableReader& top, const Replay& replay) {
  std::set<Key> known;
  for (const Sweep& sweep : replay.sweeps) {
    Replay one = replay;
    one.sweeps = {sweep};
    for (const Replay& part : expand(one))
      for (Key& key : keys_of(part))
        if (const auto [found, added] = known.insert(std::move(key)); !added) {
          top.report(toml::source_position{sweep.at.line, sweep.at.column},
                     fmt::format("{} of {} is spanned twice, expected every job once", std::get<2>(*found),
                                 std::get<0>(*found)));
          return;
        }
  }
}

}  // namespace

void read_sweeps(TableReader& top, Replay& replay) {
  const size_t mistakes = top.mistakes();
  top.tables("sweep", kMaxSweeps, [&](TableReader& table) { replay.sweeps.push_back(read_sweep(table)); });
  for (const char* other : {"scene", "ticks", "seed", "method", "shot"})
    if (top.has(other))
      top.report(other, fmt::format("`{}` stands beside [[sweep]], expected one of them: a sweep has its own",
                                    other));
  double jobs = 0;
  for (const Sweep& sweep : replay.sweeps) jobs += jobs_of(sweep);
  if (jobs > kMaxJobs)
    top.report("sweep", fmt::format("{} jobs are spanned, expected at most {}", jobs, kMaxJobs));
  else if (top.mistakes() == mistakes)
    report_repeated(top, replay);
}

}  // namespace plume
