// Arguments to one command, and every way to fail to its exit code.
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>

#include "renderer/gpu/errors.h"
#include "renderer/parameters.h"
#include "sandbox/commands/command.h"
#include "sandbox/commands/help.h"

namespace {

/// CLI11 says what it did not expect; people want to know what they meant.
std::string explain(const CLI::App& program, const CLI::ParseError& error) {
  const auto used = program.get_subcommands();
  const std::vector<std::string> extras = program.remaining(true);
  std::vector<std::string> valid;
  for (const CLI::Option* option : (used.empty() ? program : *used.front()).get_options())
    for (const std::string& name : option->get_lnames()) valid.push_back("--" + name);
  if (used.empty()) {
    for (const CLI::App* command : program.get_subcommands({})) valid.push_back(command->get_name());
    if (extras.empty())
      return fmt::format("a command is missing, expected one of `{}`", fmt::join(valid, "`, `"));
    return fmt::format("unknown command `{}`, {}", extras.front(), plume::suggestion(extras.front(), valid));
  }
  const auto flag =
      std::find_if(extras.begin(), extras.end(), [](const std::string& e) { return e.starts_with('-'); });
  if (flag == extras.end()) return error.what();
  const std::string name = flag->substr(0, flag->find('=')), command = used.front()->get_name();
  if (std::find(valid.begin(), valid.end(), name) != valid.end())
    return fmt::format("{} stands before {}, expected after it", name, command);
  return fmt::format("unknown flag `{}` of {}, {}", name, command, plume::suggestion(name, valid));
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
  program.formatter(std::make_shared<Help>());
  Run run;
  for (auto* add : {add_open, add_compare, add_replay, add_probe, add_inspect, add_diff, add_check, add_list,
                    add_merge, add_stress})
    add(program, run);
  try {
    auto arguments = with_open(program, {argv + 1, argv + argc});
    std::reverse(arguments.begin(), arguments.end());  // as the parser takes them
    program.parse(arguments);
    const int code = run();
    if (std::fflush(stdout) != 0)
      return fail(kBadUsage, fmt::format("standard output: {}", std::generic_category().message(errno)));
    return code;
  } catch (const CLI::CallForHelp&) {
    fmt::print("{}", program.help());
    return kDone;
  } catch (const CLI::ParseError& error) {
    return fail(kBadUsage, explain(program, error));
  } catch (const gpu::NoUsableDevice& error) {
    return fail(kNoDevice, error.what());
  } catch (const gpu::DeviceFailure& error) {
    return fail(kDeviceFailed, error.what());
  } catch (const vk::SystemError& error) {
    return fail(kDeviceFailed, fmt::format("the device failed: {}", error.what()));
  } catch (const std::bad_alloc&) {
    return fail(kDeviceFailed, "out of memory");
  } catch (const Interrupted& error) {
    return fail(kInterrupted, error.what());
  } catch (const std::exception& error) {  // an input file, an argument, a folder: the message says which
    return fail(kBadUsage, error.what());
  }
}
