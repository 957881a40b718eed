// plume merge DIR...: the results of shards as those of one machine.
#include "sandbox/runs/merge.h"

#include "sandbox/commands/command.h"

namespace plume {
namespace {

struct MergeFlags : OutputFlags {
  std::vector<std::string> parts;
};

int run_merge(const MergeFlags& flags) {
  print_results(merge({flags.parts.begin(), flags.parts.end()}, flags.out), flags);
  return kDone;
}

}  // namespace

void add_merge(CLI::App& program, Run& run) {
  auto flags = std::make_shared<MergeFlags>();
  CLI::App* command = program.add_subcommand("merge", "joins the results of shards");
  command->add_option("DIR", flags->parts, "folders that runs with --shard wrote")->required();
  add_output_flags(*command, *flags, "Options");
  command->get_option("--out")->required()->default_str("");
  command->callback([flags, &run] { run = [flags] { return run_merge(*flags); }; });
}

}  // namespace plume
