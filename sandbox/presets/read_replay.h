// Reads presets/replays/*.toml. The keys are the members of Replay; a [[method]] takes `id`, and its other
// keys are settings. A [[shot]] says which [[method]] by its place, the first is 1; its `view` is shown in
// the place of the picture. [[sweep]]: read_sweep.h.
#ifndef PLUME_PRESETS_READ_REPLAY_H
#define PLUME_PRESETS_READ_REPLAY_H

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/presets/diagnostics.h"
#include "sandbox/scene/replay.h"

namespace plume {

class PresetLibrary;

/// Throws FileErrors with everything that is wrong in the file, methods and their settings included. The
/// folder beside the file that has its name without extension, if there is one, is where scenes and effects
/// are looked up first.
Replay read_replay(const std::filesystem::path& path);
/// The same from text; `file` names it in messages and gives the id.
Replay read_replay_text(std::string_view text, const std::string& file);

/// A diagnostic for each scene that the library does not have.
std::vector<Diagnostic> check_references(const Replay& replay, const PresetLibrary& library);

}  // namespace plume
#endif
