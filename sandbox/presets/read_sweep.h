// Reads [[sweep]] of a replay. The keys are the members of Sweep; each [[sweep.method]] has an `id`, and its
// other keys are settings, where a list is the values that are spanned.
#ifndef PLUME_PRESETS_READ_SWEEP_H
#define PLUME_PRESETS_READ_SWEEP_H

#include "sandbox/presets/table_reader.h"
#include "sandbox/scene/replay.h"

namespace plume {

/// All sweeps of a file, whose other keys are read. Reports what does not stand beside them, more jobs than
/// can be drawn, and a job that is spanned twice.
void read_sweeps(TableReader& top, Replay& replay);

}  // namespace plume
#endif
