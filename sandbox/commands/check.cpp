// plume check FILE...: everything wrong in effects, scenes and scripts, all at once.
#include "sandbox/presets/check.h"

#include <fmt/format.h>

#include "sandbox/commands/command.h"

namespace plume {
namespace {

struct CheckFlags {
  std::vector<std::string> files;
  bool json = false;
};

int run_check(const CheckFlags& flags) {
  const PresetLibrary library(preset_root());
  nlohmann::json found = nlohmann::json::array();
  for (const std::string& file : flags.files) {
    const auto diagnostics = check_file(file, &library);
    for (const Diagnostic& d : diagnostics) {
      found.push_back({{"file", d.file}, {"line", d.line}, {"column", d.column}, {"message", d.message}});
      if (!flags.json) fmt::print("{}:{}:{}: {}\n", d.file, d.line, d.column, d.message);
    }
    if (diagnostics.empty() && !flags.json) fmt::print("{}: ok\n", file);
  }
  // A file's name, or what it holds, may not be UTF-8.
  if (flags.json) fmt::print("{}\n", found.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  return found.empty() ? kDone : kBadUsage;
}

}  // namespace

void add_check(CLI::App& program, Run& run) {
  auto flags = std::make_shared<CheckFlags>();
  CLI::App* command = program.add_subcommand("check", "validates effects, scenes and scripts");
  command->add_option("FILE", flags->files, "TOML files")->required();
  command->add_flag("--json", flags->json, "an array of {file, line, column, message}");
  command->callback([flags, &run] { run = [flags] { return run_check(*flags); }; });
}

}  // namespace plume
