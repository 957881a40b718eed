// A replay as the text of a file that reads back as the same: the end of a recording.
#ifndef PLUME_PRESETS_WRITE_REPLAY_H
#define PLUME_PRESETS_WRITE_REPLAY_H

#include <string>

#include "sandbox/scene/replay.h"

namespace plume {

/// All but the id and the folder of presets, which the file's place gives, of a replay without sweeps.
std::string replay_text(const Replay& replay);

}  // namespace plume
#endif
