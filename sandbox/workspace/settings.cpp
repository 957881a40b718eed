#include "sandbox/workspace/settings.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/methods/methods.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/table_reader.h"
#include "sandbox/presets/toml_text.h"

namespace plume {
namespace fs = std::filesystem;
namespace {

constexpr size_t kMostRecent = 12;
constexpr Limits kScreen{-100'000, 100'000, "screen coordinates"};
constexpr Limits kWindowSide{1, 100'000, "screen coordinates"};

void read_window(TableReader& window, Settings& out) {
  window.size("size", out.window_size, kWindowSide);
  if (window.has("x") || window.has("y")) {
    glm::ivec2& corner = out.window_corner.emplace(0);
    window.integer("x", corner.x, kScreen, Need::kRequired);
    window.integer("y", corner.y, kScreen, Need::kRequired);
  }
  window.toggle("full_screen", out.full_screen);
  window.toggle("panels", out.panels);
  window.number("text_scale", out.text_scale, {kSmallestText, kLargestText});
}

void read_side(TableReader& side, SideSettings& out) {
  side.text("method", out.method);
  side.table("parameters", [&](TableReader& methods) {
    for (const std::string& method : methods.keys())
      methods.table(method, [&](TableReader& table) {
        for (const Setting& setting : table.settings()) out.parameters[method][setting.key] = setting.value;
      });
  });
}

/// The parameters that are not what the method begins with.
std::map<std::string, std::string> changed_parameters(Method& method) {
  std::map<std::string, std::string> changed;
  const auto fresh = make_method(method.id());
  const auto before = parameter_texts(*fresh);
  for (const auto& [name, value] : parameter_texts(method))
    if (before.at(name) != value) changed[name] = value;
  return changed;
}

std::string side_text(const char* name, const SideSettings& side) {
  std::string text = fmt::format("\n[{}]\n", name);
  if (!side.method.empty()) text += fmt::format("method = {}\n", quoted_text(side.method));
  for (const auto& [method, parameters] : side.parameters) {
    text += fmt::format("[{}.parameters.{}]\n", name, quoted_text(method));
    for (const auto& [parameter, value] : parameters)
      text += fmt::format("{} = {}\n", quoted_text(parameter), quoted_text(value));
  }
  return text;
}

void take_side(Side& side, SideSettings& out) {
  out = {.method = std::string(side.method().method->id()), .parameters = {}};
  for (const MethodInstance& instance : side.methods)
    if (auto changed = changed_parameters(*instance.method); !changed.empty())
      out.parameters[std::string(instance.method->id())] = std::move(changed);
}

void apply_side(const SideSettings& settings, Workspace& workspace, Side& side,
                std::vector<std::string>& left_out) {
  const auto find = [&](const std::string& id) {
    const auto found = std::ranges::find_if(
        side.methods, [&](const MethodInstance& instance) { return instance.method->id() == id; });
    if (found == side.methods.end()) left_out.push_back(fmt::format("there is no method `{}` any more", id));
    return found;
  };
  for (const auto& [id, parameters] : settings.parameters) {
    const auto instance = find(id);
    if (instance == side.methods.end()) continue;
    for (const auto& [name, value] : parameters) try {
        set_parameter(*instance->method, name, value);
      } catch (const ParameterError& error) {
        left_out.push_back(error.what());
      }
  }
  if (settings.method.empty()) return;
  const auto chosen = find(settings.method);
  if (chosen == side.methods.end()) return;
  if (const auto missing = chosen->method->missing(workspace.device()); !missing.empty())
    left_out.push_back(fmt::format("this device cannot run {}", settings.method));
  else
    workspace.choose_method(side, size_t(chosen - side.methods.begin()));
}

}  // namespace

Settings read_settings_text(std::string_view text, const std::string& file) {
  Settings settings;
  read_document(text, file, [&](TableReader& top) {
    top.text("scene", settings.scene);
    top.texts("recent_scenes", settings.recent_scenes, kMostRecent);
    top.table("window", [&](TableReader& window) { read_window(window, settings); });
    top.table("resolution", [&](TableReader& resolution) {
      resolution.toggle("holds_rate", settings.holds_rate);
      resolution.number("frames_per_second", settings.frames_per_second, {1, 1000, "1/s"});
      uint32_t step = 0;
      if (resolution.integer("step", step, {0, double(ResolutionControl::kScales.size() - 1)}))
        settings.resolution_step = step;
    });
    top.table("a", [&](TableReader& side) { read_side(side, settings.a); });
    top.table("b", [&](TableReader& side) { read_side(side, settings.b); });
  });
  return settings;
}

std::string settings_text(const Settings& settings) {
  std::string text = "# What plume keeps from one session to the next; written when its window is closed.\n";
  if (!settings.scene.empty()) text += fmt::format("scene = {}\n", quoted_text(settings.scene));
  std::vector<TomlValue> recent;
  for (const std::string& scene : settings.recent_scenes) recent.push_back({scene});
  if (!recent.empty()) text += fmt::format("recent_scenes = {}\n", to_toml({std::move(recent)}));
  text += fmt::format("\n[window]\nsize = [{}, {}]\n", settings.window_size.x, settings.window_size.y);
  if (const auto& corner = settings.window_corner)
    text += fmt::format("x = {}\ny = {}\n", corner->x, corner->y);
  text += fmt::format("full_screen = {}\npanels = {}\ntext_scale = {}\n", settings.full_screen,
                      settings.panels, to_toml({settings.text_scale}));
  text += fmt::format("\n[resolution]\nholds_rate = {}\nframes_per_second = {}\n", settings.holds_rate,
                      to_toml({settings.frames_per_second}));
  if (settings.resolution_step) text += fmt::format("step = {}\n", *settings.resolution_step);
  return text + side_text("a", settings.a) + side_text("b", settings.b);
}

Settings load_settings(const fs::path& file) {
  std::error_code absent;
  if (!fs::exists(file, absent)) return {};
  return read_settings_text(load_text(file), file.string());
}

std::string put_aside(const fs::path& file) {
  fs::path aside = file;
  aside += ".broken";
  std::error_code failure;
  fs::rename(file, aside, failure);
  return failure ? fmt::format("The settings begin anew; the broken file cannot be put aside: {}.",
                               failure.message())
                 : fmt::format("The settings begin anew; the broken file is now {}.", aside.string());
}

void save_settings(const fs::path& file, const Settings& settings) {
  make_folder(file.parent_path());
  replace_file(file, settings_text(settings));
}

void visit_scene(Settings& settings, const std::string& scene) {
  if (settings.scene == scene && !settings.recent_scenes.empty() && settings.recent_scenes.front() == scene)
    return;
  settings.scene = scene;
  std::erase(settings.recent_scenes, scene);
  settings.recent_scenes.insert(settings.recent_scenes.begin(), scene);
  if (settings.recent_scenes.size() > kMostRecent) settings.recent_scenes.resize(kMostRecent);
}

void take_settings(Workspace& workspace, Settings& settings) {
  take_side(workspace.a, settings.a);
  take_side(workspace.b, settings.b);
  settings.holds_rate = workspace.resolution.adapts;
  settings.frames_per_second = float(workspace.resolution.frames_per_second);
  settings.resolution_step = uint32_t(workspace.resolution.step());
}

std::vector<std::string> apply_settings(const Settings& settings, Workspace& workspace) {
  std::vector<std::string> left_out;
  apply_side(settings.a, workspace, workspace.a, left_out);
  apply_side(settings.b, workspace, workspace.b, left_out);
  workspace.resolution.adapts = settings.holds_rate;
  workspace.resolution.frames_per_second = double(settings.frames_per_second);
  if (settings.resolution_step) workspace.resolution.set_step(*settings.resolution_step);
  return left_out;
}

}  // namespace plume
