// How far a run is, on standard error: one line that is rewritten on a terminal, plain lines in a pipe, where
// what is not done yet is told of twice a minute.
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
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now(), told_ = start_;
  bool line_is_open_ = false;
};

}  // namespace plume
#endif
