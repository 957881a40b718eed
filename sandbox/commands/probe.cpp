// plume probe SCENE --pixel X,Y: the fragments of one pixel, and what each method believes of the
// transmittance in front of any depth there.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "renderer/methods/methods.h"
#include "renderer/methods/parts/fragment_list.h"
#include "sandbox/commands/command.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/scene/stage.h"

namespace plume {
namespace {

using nlohmann::json;

struct ProbeFlags : DrawFlags {
  std::string scene;
  std::vector<uint32_t> pixel;
  std::vector<std::string> methods{"all"};
  std::optional<uint32_t> tick;
  uint32_t depths = 128;
  std::pair<float, float> range{0.0f, 0.0f};
  bool csv = false;
};

json colour(glm::vec3 c) {
  return {c.r, c.g, c.b};
}

/// Of the reference's frame just drawn, front to back.
std::vector<shared::FragmentNode> exact_fragments(GpuSession& gpu, const Stage& stage, const Targets& targets,
                                                  glm::uvec2 pixel) {
  MethodInstance reference{.method = make_method("reference"), .owner = "ground truth", .resources = {}};
  render_frame(gpu.device, gpu.pipelines, targets, stage.prelude(), stage.transparents(), reference);
  return fragment_list::fragments_at(gpu.device, reference.resources, targets.size, pixel);
}

json fragments_json(const std::vector<shared::FragmentNode>& fragments) {
  json list = json::array();
  glm::vec3 through(1.0f);
  for (const shared::FragmentNode& f : fragments) {
    list.push_back({{"depth_m", f.depth},
                    {"card", f.id},
                    {"light", colour(f.light)},
                    {"transmittance", colour(f.transmittance)},
                    {"weight", colour(through)}});
    through *= f.transmittance;
  }
  return list;
}

/// As asked for, or from a little before the first fragment to a little behind the last, evenly in ratio.
std::vector<float> depths_of(const ProbeFlags& flags, const std::vector<shared::FragmentNode>& fragments) {
  auto [nearest, farthest] = flags.range;
  if (farthest == 0.0f) {
    nearest = fragments.empty() ? 1.0f : fragments.front().depth * 0.9f;
    farthest = fragments.empty() ? 100.0f : fragments.back().depth * 1.1f;
  }
  std::vector<float> depths;
  for (uint32_t i = 0; i < flags.depths; ++i)
    depths.push_back(nearest *
                     std::pow(farthest / nearest, float(i) / float(std::max(flags.depths, 2u) - 1)));
  return depths;
}

std::string to_csv(const json& result) {
  std::string csv = "depth_m";
  for (const json& method : result["methods"])
    for (const char* channel : {"r", "g", "b"})
      csv += fmt::format(",{}_{}", method["method"].get<std::string>(), channel);
  csv += "\n";
  for (size_t i = 0; i < result["depths_m"].size(); ++i) {
    csv += fmt::format("{}", result["depths_m"][i].get<float>());
    for (const json& method : result["methods"])
      for (size_t c = 0; c < 3; ++c)
        csv += method["transmittance"].is_null()
                   ? std::string(",")
                   : fmt::format(",{}", method["transmittance"][i][c].get<float>());
    csv += "\n";
  }
  return csv;
}

int run_probe(const ProbeFlags& flags) {
  const PresetLibrary library(preset_root());
  Scene scene = library.scene(flags.scene);
  if (auto unknown = check_references(scene, library); !unknown.empty()) throw FileErrors(std::move(unknown));
  if (flags.seed) scene.seed = *flags.seed;
  std::vector<Replay> replays(1);  // settings are applied to the methods of replays
  replays[0].methods = method_runs(flags.methods);
  apply_settings(flags.set, replays);
  const glm::uvec2 size = flags.size.value_or(replays[0].size), pixel{flags.pixel[0], flags.pixel[1]};
  if (pixel.x >= size.x || pixel.y >= size.y)
    throw UsageError(
        fmt::format("--pixel {},{}: the picture ends at {},{}", pixel.x, pixel.y, size.x - 1, size.y - 1));
  if (flags.range.second != 0.0f && !(flags.range.first > 0 && flags.range.second > flags.range.first))
    throw UsageError(
        fmt::format("--range {} {}: expected two depths in metres, the first above 0 and below "
                    "the second",
                    flags.range.first, flags.range.second));

  GpuSession gpu(flags);
  const uint32_t tick = flags.tick.value_or(scene.default_tick);
  Stage stage(gpu.device, gpu.pipelines, library, std::move(scene));
  const Targets targets(gpu.device, size, stage.post());
  stage.go_to(tick, size);
  const auto fragments = exact_fragments(gpu, stage, targets, pixel);
  const std::vector<float> depths = depths_of(flags, fragments);

  json result{{"scene", stage.scene().id},
              {"tick", tick},
              {"size", {size.x, size.y}},
              {"pixel", {pixel.x, pixel.y}},
              {"fragments", fragments_json(fragments)},
              {"depths_m", depths},
              {"methods", json::array()}};
  for (const MethodRun& method_run : replays[0].methods) {
    MethodInstance instance{.method = make_method(method_run.id), .owner = method_run.id, .resources = {}};
    for (const auto& [name, value] : method_run.settings) set_parameter(*instance.method, name, value);
    json told{{"method", method_run.id},
              {"settings", parameter_values(*instance.method)},
              {"status", "ok"},
              {"transmittance", nullptr}};
    if (const auto missing = instance.method->missing(gpu.device); !missing.empty()) {
      told["status"] = fmt::format("unavailable: needs {}", fmt::join(missing, ", "));
    } else {
      const Probe probe(gpu.device, pixel, depths);
      render_frame(gpu.device, gpu.pipelines, targets, stage.prelude(), stage.transparents(), instance,
                   &probe);
      told["transmittance"] = json::array();
      for (const glm::vec3& t : probe.read_answer(gpu.device)) told["transmittance"].push_back(colour(t));
    }
    result["methods"].push_back(std::move(told));
  }
  fmt::print("{}", flags.csv ? to_csv(result) : result.dump(2) + "\n");
  return report_validation(gpu.device);
}

}  // namespace

void add_probe(CLI::App& program, Run& run) {
  auto flags = std::make_shared<ProbeFlags>();
  CLI::App* command = program.add_subcommand(
      "probe", "fragments of one pixel, and each method's transmittance over depth there");
  command->add_option("SCENE", flags->scene, "id of `plume list scenes`, or a file")->required();
  command->add_option("--pixel", flags->pixel, "X,Y from the upper left, from 0")
      ->delimiter(',')
      ->expected(2)
      ->required();
  command->add_option("--methods", flags->methods, "all, or ids of `plume list methods`, comma-separated")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--at", flags->tick, "tick, 1/60 s; otherwise the scene's own")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--depths", flags->depths, "how many depths are asked for")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  command->add_option("--range", flags->range,
                      "nearest and farthest depth, m; otherwise around the pixel's fragments");
  command->add_flag("--csv", flags->csv, "a line for each depth instead of JSON");
  add_picture_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_probe(*flags); }; });
}

}  // namespace plume
