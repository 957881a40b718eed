// How far a run is, on standard error: one line that is rewritten on a terminal, plain lines in a pipe.
#ifndef PLUME_COMMANDS_PROGRESS_H
#define PLUME_COMMANDS_PROGRESS_H

#include <chrono>

#include "sandbox/runs/measurement.h"

namespace plume {

class Progress {
 public:
  ~Progress();
  /// The time that is left is told from what this run has drawn itself.
  void operator()(const Headway& headway);

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  bool line_is_open_ = false;
};

}  // namespace plume
#endif
