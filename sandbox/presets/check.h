// What `plume check` says about a file.
#ifndef PLUME_PRESETS_CHECK_H
#define PLUME_PRESETS_CHECK_H

#include <filesystem>
#include <vector>

#include "sandbox/presets/diagnostics.h"

namespace plume {

class PresetLibrary;

/// Everything wrong in an effect, scene or replay; empty when it is good. The folder (effects/, scenes/,
/// replays/) tells which of them it is, else its content: [[emitter]] makes an effect, `scene` a replay,
/// anything else a scene. The presets it names are looked up in the tree it stands in, else in `library`,
/// else not at all.
std::vector<Diagnostic> check_file(const std::filesystem::path& path, const PresetLibrary* library = nullptr);

}  // namespace plume
#endif
