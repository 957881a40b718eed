#include "sandbox/scene/sweep.h"

#include <algorithm>
#include <optional>

#include "sandbox/scene/replay.h"

namespace plume {
namespace {

/// All combinations; the last parameter by name varies fastest.
std::vector<MethodRun> runs_of(const MethodSpan& span) {
  std::vector<MethodRun> runs{{.id = span.id, .settings = {}}};
  for (const auto& [name, values] : span.settings) {
    std::vector<MethodRun> longer;
    for (const MethodRun& run : runs)
      for (const std::string& value : values) longer.emplace_back(run).settings[name] = value;
    runs = std::move(longer);
  }
  return runs;
}

double at_least_one(size_t count) {
  return double(std::max<size_t>(count, 1));
}

}  // namespace

double jobs_of(const Sweep& sweep) {
  double methods = 0;
  for (const MethodSpan& span : sweep.methods) {
    double runs = 1;
    for (const auto& [name, values] : span.settings) runs *= double(values.size());
    methods += runs;
  }
  return methods * double(sweep.scenes.size()) * at_least_one(sweep.ticks.size()) *
         at_least_one(sweep.sizes.size()) * at_least_one(sweep.seeds.size());
}

std::vector<Replay> expand(const Replay& replay) {
  if (replay.sweeps.empty()) return {replay};
  std::vector<Replay> expanded;
  for (const Sweep& sweep : replay.sweeps) {
    Replay one = replay;
    one.sweeps.clear();
    one.scene_at = sweep.scenes_at;
    one.ticks = sweep.ticks;
    for (const MethodSpan& span : sweep.methods)
      for (MethodRun& run : runs_of(span)) one.methods.push_back(std::move(run));
    const std::vector<glm::uvec2> sizes = sweep.sizes.empty() ? std::vector{replay.size} : sweep.sizes;
    std::vector<std::optional<uint32_t>> seeds(sweep.seeds.begin(), sweep.seeds.end());
    if (seeds.empty()) seeds.push_back(replay.seed);
    for (const std::string& scene : sweep.scenes)
      for (const glm::uvec2 size : sizes)
        for (const std::optional<uint32_t> seed : seeds) {
          one.scene = scene, one.size = size, one.seed = seed;
          expanded.push_back(one);
        }
  }
  return expanded;
}

}  // namespace plume
