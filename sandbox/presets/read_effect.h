// Reads presets/effects/*.toml. The keys are the members of Effect and Emitter; where it is shorter a file
// may say less.
#ifndef PLUME_PRESETS_READ_EFFECT_H
#define PLUME_PRESETS_READ_EFFECT_H

#include <filesystem>
#include <string>
#include <string_view>

#include "sandbox/effects/effect.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/field.h"

namespace plume {

class PresetLibrary;

/// More than this alive at once, in one emitter or in a scene, is an error: their state must fit one 128 MiB
/// storage buffer.
constexpr uint64_t kMaxAlive = 4'000'000;

/// Throws FileErrors with everything that is wrong in the file. Meshes are named, not read: see
/// check_references() and PresetLibrary.
Effect read_effect(const std::filesystem::path& path);
/// The same from text; `file` names it in messages and gives the id.
Effect read_effect_text(std::string_view text, const std::string& file);

/// What the file says and could say: everything that its reader asks for, in that order. It has what could
/// be read where the text has mistakes, and nothing where it is no TOML.
std::vector<Field> effect_fields(std::string_view text, const std::string& file);

/// Where the vector fields are that the effect in a file names.
std::filesystem::path field_folder(const std::filesystem::path& file);

/// Every mesh that an emitter names, in the order of the file.
std::vector<MeshName> mesh_names(const Effect& effect);
/// A diagnostic for each of them that the library does not have.
std::vector<Diagnostic> check_references(const Effect& effect, const PresetLibrary& library);

}  // namespace plume
#endif
