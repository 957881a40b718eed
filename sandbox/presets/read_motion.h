// The [emitter.motion] table of an effect.
#ifndef PLUME_PRESETS_READ_MOTION_H
#define PLUME_PRESETS_READ_MOTION_H

#include "sandbox/presets/table_reader.h"

namespace plume {

/// `fields` is the folder of vector fields.
void read_motion(TableReader& motion, const std::filesystem::path& fields, Motion& out);

}  // namespace plume
#endif
