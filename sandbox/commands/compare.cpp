// plume compare SCENE...: accuracy and time of methods against the exact reference.
#include <fmt/format.h>

#include "sandbox/commands/command.h"
#include "sandbox/presets/preset_file.h"

namespace plume {
namespace {

struct CompareFlags : DrawFlags {
  std::vector<std::string> scenes;
  std::vector<std::string> methods{"all"};
  std::optional<uint32_t> tick;
  uint32_t frames = 5;
};

int run_compare(const CompareFlags& flags) {
  const SteadyTexts texts;
  const PresetLibrary library(preset_root());
  std::vector<Replay> replays;
  for (const std::string& name : flags.scenes) {
    const Scene scene = library.scene(name);
    Replay replay;
    replay.id = replay.name = scene.id;
    replay.scene = name;
    replay.ticks = {flags.tick.value_or(scene.default_tick)};
    replay.frames = flags.frames;
    replay.methods = method_runs(flags.methods);
    replays.push_back(std::move(replay));
  }
  return measure_and_report(std::move(replays), library, flags);
}

}  // namespace

void add_compare(CLI::App& program, Run& run) {
  auto flags = std::make_shared<CompareFlags>();
  CLI::App* command =
      program.add_subcommand("compare", "accuracy and time of methods against the exact reference");
  command->add_option("SCENE", flags->scenes, "ids of `plume list scenes`, or files")->required();
  command->add_option("--methods", flags->methods, "all, or ids of `plume list methods`, comma-separated")
      ->type_name("METHODS")
      ->delimiter(',')
      ->allow_extra_args(false);  // what follows is a scene
  command->add_option("--at", flags->tick, "tick, 1/60 s; otherwise the scene's own")
      ->type_name("TICK")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--frames", flags->frames, "timed repetitions of each method")
      ->type_name("N")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command->add_flag("--sensitivity", flags->sensitivity,
                    "move each parameter of each method alone, and tell which buys most accuracy per "
                    "millisecond; writes no pictures");
  add_draw_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_compare(*flags); }; });
}

}  // namespace plume
