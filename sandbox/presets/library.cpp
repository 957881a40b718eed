#include "sandbox/presets/library.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "renderer/parameters.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/read_scene.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

std::string_view word(PresetKind kind) {
  return kind == PresetKind::kEffect ? "effect" : kind == PresetKind::kScene ? "scene" : "replay";
}

}  // namespace

std::vector<std::string> PresetLibrary::ids(PresetKind kind) const {
  std::vector<std::string> ids;
  std::error_code absent;  // a folder that is not there holds nothing
  for (const fs::directory_entry& entry :
       fs::directory_iterator(root_ / fmt::format("{}s", word(kind)), absent))
    if (entry.path().extension() == ".toml") ids.push_back(entry.path().stem().string());
  std::ranges::sort(ids);
  return ids;
}

fs::path PresetLibrary::find(PresetKind kind, std::string_view name) const {
  if (name.find('/') != name.npos || name.ends_with(".toml")) {
    if (!fs::exists(name))
      throw PresetError(fmt::format("there is no file {}, expected a path to a {}", name, word(kind)));
    return name;
  }
  const std::vector<std::string> known = ids(kind);
  if (std::ranges::binary_search(known, name))
    return root_ / fmt::format("{}s", word(kind)) / fmt::format("{}.toml", name);
  throw PresetError(fmt::format("unknown {} `{}`, {}", word(kind), name, suggestion(name, known)));
}

Effect PresetLibrary::effect(std::string_view name) const {
  return read_effect(find(PresetKind::kEffect, name));
}
Scene PresetLibrary::scene(std::string_view name) const {
  return read_scene(find(PresetKind::kScene, name));
}
Replay PresetLibrary::replay(std::string_view name) const {
  return read_replay(find(PresetKind::kReplay, name));
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
