// Arguments to one command, and every way to fail to its exit code.
#include <fmt/format.h>

#include <cstdio>

#include "renderer/gpu/errors.h"
#include "renderer/parameters.h"
#include "sandbox/commands/command.h"

namespace {

/// CLI11 says what it did not expect; people want to know what they meant.
std::string with_nearest(const CLI::App& program, const CLI::ParseError& error) {
  std::string message = error.what();
  const auto used = program.get_subcommands();
  const CLI::App& command = used.empty() ? program : *used.front();
  std::vector<std::string> valid;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) valid.push_back("--" + name);
  for (const CLI::App* sub : command.get_subcommands({})) valid.push_back(sub->get_name());
  for (const std::string& extra : command.remaining())
    if (const std::string close = plume::nearest(extra.substr(0, extra.find('=')), valid); !close.empty())
      message += fmt::format("; did you mean {}?", close);
  return message;
}

int fail(int code, const std::string& message) {
  fmt::print(stderr, "plume: {}\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace plume;
  CLI::App program("Plume: particle effects and order-independent transparency, measured.", "plume");
  program.require_subcommand(1);
  program.get_formatter()->column_width(28);
  Run run;
  for (auto* add : {add_compare, add_replay, add_diff, add_check, add_list}) add(program, run);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", program.help());
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail(kBadUsage, with_nearest(program, error));
  }

  try {
    return run();
  } catch (const gpu::NoUsableDevice& error) {
    return fail(kNoDevice, error.what());
  } catch (const gpu::DeviceFailure& error) {
    return fail(kDeviceFailed, error.what());
  } catch (const Interrupted& error) {
    return fail(kInterrupted, error.what());
  } catch (const std::exception& error) {   // an input file, an argument, a folder: the message says which
    return fail(kBadUsage, error.what());
  }
}
