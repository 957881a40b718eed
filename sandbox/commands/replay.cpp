// plume replay SCRIPT...: plays scripts without a display; images, error maps and results on disk.
#include "sandbox/commands/command.h"
#include "sandbox/presets/preset_file.h"

namespace plume {
namespace {

struct ReplayFlags : DrawFlags {
  std::vector<std::string> scripts;
};

int run_replay(const ReplayFlags& flags) {
  const SteadyTexts texts;
  const PresetLibrary library(preset_root());
  std::vector<Replay> replays;
  for (const std::string& script : flags.scripts)
    for (Replay& replay : expand(library.replay(script))) replays.push_back(std::move(replay));
  return measure_and_report(std::move(replays), library, flags);
}

}  // namespace

void add_replay(CLI::App& program, Run& run) {
  auto flags = std::make_shared<ReplayFlags>();
  CLI::App* command = program.add_subcommand("replay", "plays a script without a display and measures it");
  command->add_option("SCRIPT", flags->scripts, "ids of `plume list replays`, or files")->required();
  add_draw_flags(*command, *flags);
  command->callback([flags, &run] { run = [flags] { return run_replay(*flags); }; });
}

}  // namespace plume
