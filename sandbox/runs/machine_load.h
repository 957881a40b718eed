// What the machine was doing while times were taken, as sentences for whoever reads them. On a CPU device
// (lavapipe) the processors are the device, so other processes are what times suffer from most.
//
// Read from Linux's /proc and /sys; what is not told there is left out. Limits: the clocks of a GPU are not
// looked at, those of the processors before and after only.
#ifndef PLUME_RUNS_MACHINE_LOAD_H
#define PLUME_RUNS_MACHINE_LOAD_H

#include <filesystem>

#include "sandbox/runs/results.h"

namespace plume {

struct Processor {
  std::string name = "unknown";
  unsigned threads = 1;  ///< that run at the same time
  unsigned cores = 1;    ///< without those that share one
};
/// `root` is where proc/ and sys/ are.
Processor read_processor(const std::filesystem::path& root = "/");

struct MachineLoad {
  std::optional<double> load_average;  ///< of the last minute: how many want to run
  std::string governor;                ///< of the clock, of the first processor
  std::optional<double> mhz;           ///< mean of the processors
  /// Clock ticks since the start.
  struct Ticks {
    uint64_t own = 0;     ///< of this process and its children
    uint64_t busy = 0;    ///< of all processes and the system
    uint64_t stolen = 0;  ///< that the host gave to other machines
    uint64_t total = 0;   ///< that there were, idle ones too
  };
  std::optional<Ticks> ticks;
};
MachineLoad read_machine_load(const std::filesystem::path& root = "/");

/// What makes times doubtful that were taken in between; nothing where nothing does.
std::vector<Note> load_notes(const MachineLoad& before, const MachineLoad& after, unsigned threads);

}  // namespace plume
#endif
