// plume probe SCENE --pixel X,Y: the fragments of one pixel, and what each method believes of the
// transmittance in front of any depth there.
#include <fmt/format.h>

#include "renderer/methods/methods.h"
#include "sandbox/commands/command.h"
#include "sandbox/measure/pixel_probe_text.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_scene.h"

namespace plume {
namespace {

struct ProbeFlags : DrawFlags {
  std::string scene;
  std::vector<uint32_t> pixel;
  std::vector<std::string> methods{"all"};
  std::optional<uint32_t> tick;
  uint32_t depth_count = ProbedDepths{}.count;
  std::pair<float, float> range{0.0f, 0.0f};
  bool csv = false, csv_fragments = false;

  ProbedDepths depths() const {
    ProbedDepths asked{.count = depth_count};
    if (range.second != 0.0f) asked.range_m = range;
    return asked;
  }
};

int run_probe(const ProbeFlags& flags) {
  const SteadyTexts texts;
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

  gpu::Frame cards_alone(gpu.device, gpu.pipelines);  // fragments need no method
  stage.prelude().geometry(cards_alone, targets);
  cards_alone.finish();
  PixelProbe probe = probe_pixel(gpu.device, gpu.pipelines, stage, targets, pixel, flags.depths());
  for (const MethodRun& method_run : replays[0].methods) {
    MethodInstance instance{.method = make_method(method_run.id), .owner = method_run.id, .resources = {}};
    for (const auto& [name, value] : method_run.settings) set_parameter(*instance.method, name, value);
    if (!instance.method->missing(gpu.device).empty()) {
      probe.methods.push_back(unavailable_at_pixel(gpu.device, instance));
      continue;
    }
    render_frame(gpu.device, gpu.pipelines, targets, stage.prelude(), stage.transparents(), instance);
    probe.methods.push_back(probe_method(gpu.device, gpu.pipelines, stage, targets, instance, probe));
  }
  fmt::print("{}", flags.csv_fragments ? fragments_csv(probe)
                   : flags.csv         ? curves_csv(probe)
                                       : to_json(probe).dump(2) + "\n");
  return report_validation(gpu.device);
}

}  // namespace

void add_probe(CLI::App& program, Run& run) {
  auto flags = std::make_shared<ProbeFlags>();
  CLI::App* command = program.add_subcommand(
      "probe", "fragments of one pixel, and each method's transmittance over depth there");
  command->add_option("SCENE", flags->scene, "id of `plume list scenes`, or a file")->required();
  command->add_option("--pixel", flags->pixel, "from the upper left, from 0")
      ->type_name("X,Y")
      ->delimiter(',')
      ->expected(2)
      ->required();
  command->add_option("--methods", flags->methods, "all, or ids of `plume list methods`, comma-separated")
      ->type_name("METHODS")
      ->delimiter(',')
      ->allow_extra_args(false);
  command->add_option("--at", flags->tick, "tick, 1/60 s; otherwise the scene's own")
      ->type_name("TICK")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--depths", flags->depth_count, "how many depths are asked for")
      ->type_name("N")
      ->check(CLI::Range(1, 65536))
      ->capture_default_str();
  command
      ->add_option("--range", flags->range,
                   "nearest and farthest depth, m; otherwise around the pixel's fragments")
      ->type_name("M");
  command->add_flag("--csv", flags->csv, "a line for each depth instead of JSON");
  command
      ->add_flag("--csv-fragments", flags->csv_fragments,
                 "a line for each fragment instead: whose it is, its exact weight and each method's")
      ->excludes("--csv");
  add_picture_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_probe(*flags); }; });
}

}  // namespace plume
