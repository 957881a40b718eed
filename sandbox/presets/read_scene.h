// Reads presets/scenes/*.toml. The keys are the members of Scene; [[solid]] also takes kind = "figure", a
// standing person.
#ifndef PLUME_PRESETS_READ_SCENE_H
#define PLUME_PRESETS_READ_SCENE_H

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/field.h"
#include "sandbox/scene/scene.h"

namespace plume {

class PresetLibrary;
class TableReader;

/// Throws FileErrors with everything that is wrong in the file. Effects are named, not looked up: see
/// check_references().
Scene read_scene(const std::filesystem::path& path);
/// The same from text; `file` names it in messages and gives the id.
Scene read_scene_text(std::string_view text, const std::string& file);

/// What the file says and could say, as effect_fields().
std::vector<Field> scene_fields(std::string_view text, const std::string& file);

/// A diagnostic for each instance whose effect the library does not have, or that bears too many particles on
/// its way, and for the first with which those of the whole scene no longer fit one buffer. Effects in
/// `edited`, by the name that the scene calls them, are taken instead of the library's.
std::vector<Diagnostic> check_references(const Scene& scene, const PresetLibrary& library,
                                         const std::map<std::string, Effect>& edited = {});

/// Where a camera stands and looks; no tick.
CameraKey read_camera_key(TableReader& table);
/// The [camera] or [[camera]] of a scene or a replay.
std::vector<CameraKey> read_camera(TableReader& top, bool required);

}  // namespace plume
#endif
