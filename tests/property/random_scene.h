// A scene that nobody wrote, and effects for it, as an artist with dice makes them in the editor: any field
// that the readers ask for is set to any value within its limits, tables come and go, and what the editor
// refuses, because it contradicts something else in the file, stays as it was. So a field that a reader
// learns is among them with no other edit.
#ifndef PLUME_TESTS_RANDOM_SCENE_H
#define PLUME_TESTS_RANDOM_SCENE_H

#include <filesystem>
#include <glm/glm.hpp>
#include <set>
#include <string>
#include <vector>

#include "sandbox/presets/diagnostics.h"

namespace plume {

struct RandomScene {
  std::string id;                            ///< of the scene
  std::vector<std::filesystem::path> files;  ///< the scene, and the effects that were made for it
  glm::uvec2 size;                           ///< of its picture, pixels: both sides from 1 on
  std::set<std::string> patterns;            ///< of the fields that were set, and of the tables there are
  size_t edits = 0;                          ///< that the editor took
  size_t contradictions = 0;                 ///< edits that it refused
  /// What it refused although the field says that it takes such a value.
  std::vector<Diagnostic> disagreements;
};

/// Writes the files into a new preset folder that has the shipped effects, fields and meshes too. The same
/// seed gives the same files, as long as readers and shipped presets are the same. Few particles, so that one
/// picture takes any method a fraction of a second on a CPU.
RandomScene make_random_scene(uint64_t seed, const std::filesystem::path& folder);

}  // namespace plume
#endif
