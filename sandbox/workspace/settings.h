// What a session leaves for the next one: the window, what was looked at, with which methods and parameters.
// A file in TOML in the user's config folder; no manual names its keys, but somebody may read it.
#ifndef PLUME_WORKSPACE_SETTINGS_H
#define PLUME_WORKSPACE_SETTINGS_H

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sandbox/workspace/workspace.h"

namespace plume {

/// Of text, besides what the monitor asks for.
constexpr float kSmallestText = 0.5f, kLargestText = 3.0f;

struct SideSettings {
  std::string method;  ///< "": the sandbox's own choice
  /// Method -> parameter -> value as text; those that are not the defaults.
  std::map<std::string, std::map<std::string, std::string>> parameters;
};

struct Settings {
  std::string scene;                        ///< the last one: an id or a path; "": none yet
  std::vector<std::string> recent_scenes;   ///< it and those before it, each once, the last one first
  glm::uvec2 window_size{1280, 720};        ///< in screen coordinates
  std::optional<glm::ivec2> window_corner;  ///< nothing: the desktop chooses
  bool full_screen = false;
  bool panels = true;
  float text_scale = 1.0f;
  bool holds_rate = true;
  float frames_per_second = 10.0f;
  std::optional<uint32_t> resolution_step;  ///< of ResolutionControl; nothing: the device's kind decides
  SideSettings a, b;
};

/// Throws FileErrors.
Settings read_settings_text(std::string_view text, const std::string& file);
std::string settings_text(const Settings& settings);

/// The settings in a file; the defaults where there is none. Throws FileErrors.
Settings load_settings(const std::filesystem::path& file);
/// Gives a file that is broken another name, so that it is not written over. Returns a sentence of it.
std::string put_aside(const std::filesystem::path& file);
/// Makes the folder if it is not there. Throws FileError.
void save_settings(const std::filesystem::path& file, const Settings& settings);

/// The last one from now on.
void visit_scene(Settings& settings, const std::string& scene);
/// Methods, parameters, rate and resolution, out of a workspace.
void take_settings(Workspace& workspace, Settings& settings);
/// And into one. What it does not have, such as a method of another version, is left out; returns a line for
/// each.
std::vector<std::string> apply_settings(const Settings& settings, Workspace& workspace);

}  // namespace plume
#endif
