// Finds the effects, scenes, replays and meshes of a preset folder by id (file name without extension) or by
// path.
#ifndef PLUME_PRESETS_LIBRARY_H
#define PLUME_PRESETS_LIBRARY_H

#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/effects/effect.h"
#include "sandbox/scene/replay.h"
#include "sandbox/scene/scene.h"

namespace plume {

/// Of the small pictures that presets are picked by.
constexpr glm::uvec2 kPictureSize{160, 90};

enum class PresetKind { kEffect, kScene, kReplay, kMesh };

/// A preset, or a preset folder, that is not there; the message names the nearest one that is.
struct PresetError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Looks at the folder each time it is asked, so presets saved while the program runs are found.
class PresetLibrary {
 public:
  /// `root` holds effects/, scenes/, replays/ and meshes/; each may be absent.
  explicit PresetLibrary(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  /// This one, with presets of another folder before its own; "": as it is. A path is then looked up there
  /// as well.
  PresetLibrary behind(std::filesystem::path nearer) const;
  /// Sorted.
  std::vector<std::string> ids(PresetKind kind) const;
  /// The file of a preset. A name with '/' or ending in .toml (a mesh: .obj) is a path, else an id. Throws
  /// PresetError when there is none.
  std::filesystem::path find(PresetKind kind, std::string_view name) const;

  /// The small picture of an effect or a scene: kPictureSize pixels, in pictures/effects/ or pictures/scenes/
  /// beside the folder that its file is in. Nothing: there is none, or no such preset.
  std::optional<std::filesystem::path> picture(PresetKind kind, std::string_view name) const;
  /// As find(); where there is none, the file that it would be, which may come to be.
  std::filesystem::path place(PresetKind kind, std::string_view name) const;

  /// Find and read; throw PresetError or FileErrors.
  Effect effect(std::string_view name) const;  ///< with the meshes it names
  /// The same from text; `file` names it in messages and gives the id.
  Effect effect_text(std::string_view text, const std::string& file) const;
  Mesh mesh(std::string_view name) const;
  Scene scene(std::string_view name) const;
  Replay replay(std::string_view name) const;

 private:
  std::vector<std::filesystem::path> roots() const;

  std::filesystem::path root_, nearer_;
};

/// Where the picture of the preset in a file is, or would be.
std::filesystem::path picture_path(PresetKind kind, const std::filesystem::path& preset);

/// The folder of the presets: $PLUME_PRESETS, else ../presets beside the program, else that of the source
/// tree it was built from. Throws PresetError that names every place tried; a PLUME_PRESETS that is no folder
/// is an error at once.
std::filesystem::path preset_root();

}  // namespace plume
#endif
