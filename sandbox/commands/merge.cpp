// plume merge DIR...: the results of shards as those of one machine.
#include "sandbox/measure/merge.h"

#include "sandbox/commands/command.h"

namespace plume {
namespace {

struct MergeFlags {
  std::vector<std::string> parts;
  std::string out;
  bool json = false;
};

int run_merge(const MergeFlags& flags) {
  print_results(merge({flags.parts.begin(), flags.parts.end()}, flags.out), flags.out, flags.json);
  return kDone;
}

}  // namespace

void add_merge(CLI::App& program, Run& run) {
  auto flags = std::make_shared<MergeFlags>();
  CLI::App* command = program.add_subcommand("merge", "joins the results of shards");
  command->add_option("DIR", flags->parts, "folders that runs with --shard wrote")->required();
  command->add_option("--out", flags->out, "folder for images, results.json, results.csv, report.html")
      ->required()
      ->check(
          [](const std::string& folder) { return folder.empty() ? "expected the name of a folder" : ""; });
  command->add_flag("--json", flags->json, "print results.json on standard output instead of a table");
  command->callback([flags, &run] { run = [flags] { return run_merge(*flags); }; });
}

}  // namespace plume
