#include "sandbox/presets/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "renderer/parameters.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_mesh.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/read_scene.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

struct Kind {
  std::string_view word, folder, extension;
};
constexpr Kind kKinds[] = {{"effect", "effects", ".toml"},
                           {"scene", "scenes", ".toml"},
                           {"replay", "replays", ".toml"},
                           {"mesh", "meshes", ".obj"}};
const Kind& traits(PresetKind kind) {
  return kKinds[size_t(kind)];
}

}  // namespace

PresetLibrary PresetLibrary::behind(fs::path nearer) const {
  PresetLibrary both = *this;
  if (!nearer.empty()) both.nearer_ = std::move(nearer);
  return both;
}

std::vector<fs::path> PresetLibrary::roots() const {
  return nearer_.empty() ? std::vector{root_} : std::vector{nearer_, root_};
}

std::vector<std::string> PresetLibrary::ids(PresetKind kind) const {
  std::vector<std::string> ids;
  std::error_code absent;  // a folder that is not there holds nothing
  for (const fs::path& root : roots())
    for (const fs::directory_entry& entry : fs::directory_iterator(root / traits(kind).folder, absent))
      if (entry.path().extension() == traits(kind).extension) ids.push_back(entry.path().stem().string());
  std::ranges::sort(ids);
  ids.erase(std::ranges::unique(ids).begin(), ids.end());
  return ids;
}

fs::path PresetLibrary::find(PresetKind kind, std::string_view name) const {
  if (name.find('/') != name.npos || name.ends_with(traits(kind).extension)) {
    if (!nearer_.empty() && fs::exists(nearer_ / name)) return nearer_ / name;
    if (!fs::exists(name))
      throw PresetError(fmt::format("there is no file {}, expected a path to a {}", name, traits(kind).word));
    return name;
  }
  const std::vector<std::string> known = ids(kind);
  if (std::ranges::binary_search(known, name))
    for (const fs::path& root : roots())
      if (const fs::path file =
              root / traits(kind).folder / fmt::format("{}{}", name, traits(kind).extension);
          fs::exists(file))
        return file;
  throw PresetError(fmt::format("unknown {} `{}`, {}", traits(kind).word, name, suggestion(name, known)));
}

std::optional<fs::path> PresetLibrary::picture(PresetKind kind, std::string_view name) const try {
  fs::path picture = picture_path(kind, find(kind, name));
  std::error_code unreadable;
  return fs::exists(picture, unreadable) ? std::optional(std::move(picture)) : std::nullopt;
} catch (const PresetError&) {
  return std::nullopt;
}

fs::path PresetLibrary::place(PresetKind kind, std::string_view name) const try {
  return find(kind, name);
} catch (const PresetError&) {
  if (name.find('/') != name.npos || name.ends_with(traits(kind).extension)) return name;
  return root_ / traits(kind).folder / fmt::format("{}{}", name, traits(kind).extension);
}

Effect PresetLibrary::effect(std::string_view name) const {
  const fs::path path = find(PresetKind::kEffect, name);
  return effect_text(load_text(path), path.string());
}
Effect PresetLibrary::effect_text(std::string_view text, const std::string& file) const {
  Effect effect = read_effect_text(text, file);
  if (auto missing = check_references(effect, *this); !missing.empty()) throw FileErrors(std::move(missing));
  for (const MeshName& mesh_name : mesh_names(effect))
    if (std::ranges::find(effect.meshes, mesh_name.id, &Mesh::id) == effect.meshes.end())
      effect.meshes.push_back(mesh(mesh_name.id));
  effect.text = text;
  return effect;
}
Mesh PresetLibrary::mesh(std::string_view name) const {
  return read_mesh(find(PresetKind::kMesh, name));
}
Scene PresetLibrary::scene(std::string_view name) const {
  return read_scene(find(PresetKind::kScene, name));
}
Replay PresetLibrary::replay(std::string_view name) const {
  return read_replay(find(PresetKind::kReplay, name));
}

fs::path picture_path(PresetKind kind, const fs::path& preset) {
  return preset.parent_path().parent_path() / "pictures" / traits(kind).folder /
         fs::path(preset.stem()).concat(".png");
}

fs::path preset_root() {
  std::error_code absent;
  if (const char* chosen = std::getenv("PLUME_PRESETS")) {
    if (fs::is_directory(chosen, absent)) return chosen;
    throw PresetError(
        fmt::format("PLUME_PRESETS is {}, expected a folder with effects/, scenes/ and replays/", chosen));
  }
  std::vector<std::string> places;
  const fs::path program = fs::read_symlink("/proc/self/exe", absent);
  if (!program.empty()) places.push_back((program.parent_path().parent_path() / "presets").string());
#ifdef PLUME_SOURCE_PRESETS
  places.push_back(PLUME_SOURCE_PRESETS);
#endif
  for (const std::string& place : places)
    if (fs::is_directory(place, absent)) return place;
  throw PresetError(fmt::format("no preset folder at {}, expected one there or PLUME_PRESETS to name it",
                                fmt::join(places, " or ")));
}

}  // namespace plume
