// Reads [emitter.parent]: an emitter whose particles are born of another's.
#ifndef PLUME_PRESETS_READ_PARENT_H
#define PLUME_PRESETS_READ_PARENT_H

#include "sandbox/effects/effect.h"
#include "sandbox/presets/table_reader.h"

namespace plume {

/// `earlier` are the emitters that stand before it in the file. Nothing when the parent is not known.
std::optional<Parent> read_parent(TableReader& table, const std::vector<Emitter>& earlier);
/// Births of such an emitter: a life, and no more than fit. `child.parent` is known.
void read_spawn_of_child(TableReader& spawn, const std::vector<Emitter>& earlier, Emitter& child);

}  // namespace plume
#endif
