#include "sandbox/presets/check.h"

#include <optional>

#include "sandbox/presets/library.h"
#include "sandbox/presets/preset_file.h"
#include "sandbox/presets/read_effect.h"
#include "sandbox/presets/read_mesh.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/read_scene.h"
#include "sandbox/presets/table_reader.h"

namespace plume {
namespace {

PresetKind kind_by_content(std::string_view text, const std::string& file) {
  PresetKind kind = PresetKind::kScene;
  try {
    read_document(text, file, [&](TableReader& top) {
      if (top.has("emitter"))
        kind = PresetKind::kEffect;
      else if (top.has("scene") || top.has("sweep"))
        kind = PresetKind::kReplay;
    });
  } catch (const FileErrors&) {
    // Whatever is wrong is reported when the file is read as that kind.
  }
  return kind;
}

}  // namespace

std::vector<Diagnostic> check_file(const std::filesystem::path& path, const PresetLibrary* library) {
  const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
  const std::string name = folder.filename().string(), file = path.string();
  const bool in_tree = name == "effects" || name == "scenes" || name == "replays" || name == "meshes";
  std::optional<PresetLibrary> own_tree;
  if (in_tree) library = &own_tree.emplace(folder.parent_path());
  const SteadyTexts texts;
  try {
    const std::string text = load_text(path);
    if (path.extension() == ".obj") return read_mesh_text(text, file), std::vector<Diagnostic>{};
    const PresetKind kind = name == "effects"   ? PresetKind::kEffect
                            : name == "scenes"  ? PresetKind::kScene
                            : name == "replays" ? PresetKind::kReplay
                                                : kind_by_content(text, file);
    if (kind == PresetKind::kEffect) {
      const Effect effect = read_effect_text(text, file);
      if (library) return check_references(effect, *library);
    } else if (kind == PresetKind::kScene) {
      const Scene scene = read_scene_text(text, file);
      if (library) return check_references(scene, *library);
    } else {
      const Replay replay = read_replay(path);
      if (library) return check_references(replay, *library);
    }
    return {};
  } catch (const FileErrors& errors) {
    return errors.diagnostics();
  }
}

}  // namespace plume
