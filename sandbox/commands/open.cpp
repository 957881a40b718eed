// plume open SCENE: the window. Part of the program rather than of the library, which knows no window.
#include <fmt/format.h>

#include "sandbox/commands/command.h"
#include "sandbox/commands/interruption.h"
#include "sandbox/measure/file_bytes.h"
#ifdef PLUME_WINDOW
#include "sandbox/presets/read_scene.h"
#include "sandbox/window/viewer.h"
#include "sandbox/workspace/settings.h"
#endif

namespace plume {
namespace {

struct OpenFlags : DrawFlags {
  std::string scene, screenshot, dump, view;
  std::vector<double> crosshair;
  std::vector<std::string> crosshair_methods;
  std::optional<uint32_t> tick;
  uint32_t frames = 0;
};

#ifdef PLUME_WINDOW
constexpr bool kHasWindow = true;
constexpr const char* kFirstScene = "street";

Scene checked_scene(const PresetLibrary& library, const std::string& name) {
  Scene scene = library.scene(name);
  if (auto unknown = check_references(scene, library); !unknown.empty()) throw FileErrors(std::move(unknown));
  return scene;
}

/// The scene that was asked for, else the last one, else the first of all. Notes which in the settings.
Scene first_scene(const PresetLibrary& library, const std::string& asked_for, Settings& settings) {
  std::string name = !asked_for.empty() ? asked_for : settings.scene.empty() ? kFirstScene : settings.scene;
  std::optional<Scene> scene;
  try {
    scene = checked_scene(library, name);
  } catch (const std::exception& error) {
    if (!asked_for.empty()) throw;
    warn(fmt::format("{} is no longer there to open: {}", name, error.what()));
    scene = checked_scene(library, name = kFirstScene);
  }
  if (name.find('/') != name.npos || name.ends_with(".toml")) name = std::filesystem::absolute(name).string();
  visit_scene(settings, name);
  return *std::move(scene);
}

/// The window was closed in the middle of a recording.
void save_what_is_recorded(Recording& recording, Workspace& workspace) {
  if (!recording.recorder().is_recording()) return;
  workspace.problem.clear();
  recording.toggle(workspace);
  if (const std::string& news = recording.said + workspace.problem; !news.empty()) warn(news);
}

/// What the last session left.
class KeptSettings {
 public:
  KeptSettings() {
    if (const auto folder = config_folder()) file_ = *folder / "settings.toml";
    try {
      if (!file_.empty()) settings = load_settings(file_);
    } catch (const FileErrors& errors) {
      broken_ = errors.what();
    }
  }

  /// The window is open: what could not be used is told there too.
  void begin(Viewer& viewer, Workspace& workspace) {
    Interface& interface = viewer.interface();
    interface.settings = settings;
    interface.panels = settings.panels;
    interface.full_screen = settings.full_screen;
    interface.text_scale = settings.text_scale;
    std::vector<std::string> lines = apply_settings(settings, workspace);
    if (!broken_.empty()) lines.insert(lines.end(), {broken_, put_aside(file_)});
    for (const std::string& line : lines) {
      warn(line);
      workspace.problem += line + "\n";
    }
  }

  /// The session has ended well.
  void keep(Viewer& viewer, Workspace& workspace, const GlfwWindow& window) {
    if (file_.empty()) return;
    const Interface& interface = viewer.interface();
    settings = interface.settings;
    settings.panels = interface.panels;
    settings.full_screen = interface.full_screen;
    settings.text_scale = interface.text_scale;
    const glm::ivec4 place = window.placement();
    settings.window_corner = {place.x, place.y};
    settings.window_size = {uint32_t(place.z), uint32_t(place.w)};
    take_settings(workspace, settings);
    try {
      save_settings(file_, settings);
    } catch (const FileError& error) {
      warn(fmt::format("the settings are not kept: {}", error.what()));
    }
  }

  Settings settings;

 private:
  std::filesystem::path file_;  // "": nothing is kept
  std::string broken_;
};

int run_open(const OpenFlags& flags) {
  const PresetLibrary library(preset_root());
  KeptSettings kept;
  Scene scene = first_scene(library, flags.scene, kept.settings);
  if (flags.seed) scene.seed = *flags.seed;
  const Playback playback(flags.tick.value_or(scene.default_tick), scene.duration_ticks, !flags.tick);

  GlfwWindow window(fmt::format("Plume: {}", scene.name), kept.settings.window_size,
                    kept.settings.window_corner);
  gpu::DeviceOptions options = device_options(flags);
  options.instance_extensions = window.instance_extensions();
  options.device_extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  GpuSession session(options, flags.shaders);
  {
    Workspace workspace(session.device, session.pipelines, library, std::move(scene), playback);
    if (session.device.info().is_cpu) workspace.resolution.set_step(2);  // half, which a CPU can draw
    if (const auto view = Inspector::find(*workspace.a.method().method, flags.view))
      workspace.a.view.choose(*view);
    Viewer viewer(window, workspace, flags.shaders);
    kept.begin(viewer, workspace);
    if (!flags.crosshair.empty())
      viewer.place_crosshair({flags.crosshair[0], flags.crosshair[1]}, flags.crosshair_methods);
    heed_interruptions();
    try {
      viewer.run(flags.frames, is_interrupted);
    } catch (...) {  // of a lost device too: what was recorded needs none
      save_what_is_recorded(viewer.interface().recording, workspace);
      throw;
    }
    if (!flags.dump.empty()) viewer.save_crosshair(flags.dump);
    if (!flags.screenshot.empty()) viewer.save_picture(flags.screenshot);
    save_what_is_recorded(viewer.interface().recording, workspace);
    kept.keep(viewer, workspace, window);
  }
  if (is_interrupted()) throw Interrupted("interrupted; settings and what was recorded are kept");
  return report_validation(session.device);
}
#else
constexpr bool kHasWindow = false;

int run_open(const OpenFlags&) {
  throw UsageError(
      "this build has no window (it was configured with PLUME_WINDOW=OFF); `plume compare SCENE` and `plume "
      "replay SCRIPT` draw into files without one");
}
#endif

bool is_scene(const std::string& name) try {
  PresetLibrary(preset_root()).find(PresetKind::kScene, name);
  return true;
} catch (const PresetError&) {
  return false;
}

}  // namespace

void add_open(CLI::App& program, Run& run) {
  auto flags = std::make_shared<OpenFlags>();
  CLI::App* command = program.add_subcommand("open", "a scene in a window; also what no command means");
  command->add_option("SCENE", flags->scene,
                      "an id of `plume list scenes`, or a file; otherwise the last one, at first `street`");
  command
      ->add_option("--at", flags->tick,
                   "start at this tick, 1/60 s, and paused; otherwise the scene plays from its own")
      ->type_name("TICK")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--seed", flags->seed, "instead of the scene's")
      ->type_name("N")
      ->check(CLI::Range(uint32_t(0), UINT32_MAX));
  command
      ->add_option("--device", flags->device, "part of a device's name, or its index in `plume list devices`")
      ->type_name("DEVICE");
  command->add_flag("--validate", flags->validate,
                    "run with the Vulkan validation layer; any message makes the exit code 1");
  command
      ->add_option(
          "--shaders", flags->shaders,
          "compile shaders from this folder instead of the embedded ones, and again when they change")
      ->type_name("DIR");
  const std::string hidden;  // for tests
  command->add_option("--frames", flags->frames, "close after so many")
      ->check(CLI::Range(1, 1'000'000))
      ->group(hidden);
  command->add_option("--screenshot", flags->screenshot, "PNG of the last picture, without panels")
      ->group(hidden);
  command
      ->add_option("--crosshair", flags->crosshair,
                   "X,Y: place it there, in heights of the picture from its middle to the right and down")
      ->delimiter(',')
      ->expected(2)
      ->group(hidden);
  command->add_option("--crosshair-methods", flags->crosshair_methods, "ids of methods beside those shown")
      ->delimiter(',')
      ->group(hidden);
  command->add_option("--dump", flags->dump, "JSON of what the crosshair shows at the end")->group(hidden);
  command->add_option("--view", flags->view, "that side A shows at first")->group(hidden);
  command->callback([flags, &run] { run = [flags] { return run_open(*flags); }; });
}

std::vector<std::string> with_open(const CLI::App& program, std::vector<std::string> arguments) {
  const auto is_command = [&](const CLI::App* command) { return command->get_name() == arguments.front(); };
  const auto commands = program.get_subcommands([](const CLI::App*) { return true; });
  const bool implied = arguments.empty() ? kHasWindow
                                         : !arguments.front().starts_with('-') &&
                                               std::none_of(commands.begin(), commands.end(), is_command) &&
                                               is_scene(arguments.front());
  if (implied) arguments.insert(arguments.begin(), "open");
  return arguments;
}

}  // namespace plume
