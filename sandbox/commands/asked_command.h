// How a run was asked for, less what is about that run alone: where its files go, and which of the jobs it
// draws. Whoever types it draws the same pictures.
#ifndef PLUME_COMMANDS_ASKED_COMMAND_H
#define PLUME_COMMANDS_ASKED_COMMAND_H

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace plume {

/// Flags of this group are left out.
constexpr const char* kThisRun = "This run";

/// The arguments of the program, from the name of the command on.
std::vector<std::string> asked_arguments(const CLI::App& command);
/// For a shell: "plume replay 'my script.toml'".
std::string shell_text(const std::vector<std::string>& arguments);

}  // namespace plume
#endif
