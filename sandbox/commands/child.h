// This program, run by itself: the drawing of a job that may take its process with it.
#ifndef PLUME_COMMANDS_CHILD_H
#define PLUME_COMMANDS_CHILD_H

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace plume {

struct Ending {
  int exit_code = 0;          ///< when no signal ended it
  std::optional<int> signal;  ///< that ended it
  std::string errors;         ///< the end of its standard error
};

/// "exit 4: the device was lost", "signal 6 (Aborted)": with the last line of its standard error.
std::string why(const Ending& ending);

/// Waits for the child, hands on the wish to stop, and takes the child along when this process is killed. Its
/// standard output is dropped. Throws std::runtime_error when it cannot be started.
Ending run_child(const std::vector<std::string>& arguments, const std::function<bool()>& interrupted);

}  // namespace plume
#endif
