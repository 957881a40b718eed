// plume open SCENE: the window. Part of the program rather than of the library, which knows no window.
#include <fmt/format.h>

#include "sandbox/commands/command.h"
#ifdef PLUME_WINDOW
#include "sandbox/presets/read_scene.h"
#include "sandbox/window/viewer.h"
#endif

namespace plume {
namespace {

struct OpenFlags : DrawFlags {
  std::string scene = "street", screenshot, dump, view;
  std::vector<double> crosshair;
  std::vector<std::string> crosshair_methods;
  std::optional<uint32_t> tick;
  uint32_t frames = 0;
};

#ifdef PLUME_WINDOW
constexpr bool kHasWindow = true;
constexpr glm::uvec2 kWindowSize{1280, 720};

int run_open(const OpenFlags& flags) {
  const PresetLibrary library(preset_root());
  Scene scene = library.scene(flags.scene);
  if (auto unknown = check_references(scene, library); !unknown.empty()) throw FileErrors(std::move(unknown));
  if (flags.seed) scene.seed = *flags.seed;
  const Playback playback(flags.tick.value_or(scene.default_tick), scene.duration_ticks, !flags.tick);

  GlfwWindow window(fmt::format("Plume: {}", scene.name), kWindowSize);
  gpu::DeviceOptions options = device_options(flags);
  options.instance_extensions = window.instance_extensions();
  options.device_extensions = {VK_KHR_SWAPCHAIN_EXTENSION_NAME};
  GpuSession session(options, flags.shaders);
  {
    Workspace workspace(session.device, session.pipelines, library, std::move(scene), playback);
    if (session.device.info().is_cpu) workspace.resolution.set_step(2);  // half, which a CPU can draw
    if (const auto view = Inspector::find(*workspace.a.method().method, flags.view))
      workspace.a.view.choose(*view);
    Viewer viewer(window, workspace);
    if (!flags.crosshair.empty())
      viewer.place_crosshair({flags.crosshair[0], flags.crosshair[1]}, flags.crosshair_methods);
    viewer.run(flags.frames);
    if (!flags.dump.empty()) viewer.save_crosshair(flags.dump);
    if (!flags.screenshot.empty()) viewer.save_picture(flags.screenshot);
  }
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
  command->add_option("SCENE", flags->scene, "an id of `plume list scenes`, or a file")
      ->capture_default_str();
  command
      ->add_option("--at", flags->tick,
                   "start at this tick, 1/60 s, and paused; otherwise the scene plays from its own")
      ->check(CLI::Range(0, int(kMaxTick)));
  command->add_option("--seed", flags->seed, "instead of the scene's")
      ->check(CLI::Range(uint32_t(0), UINT32_MAX));
  command->add_option("--device", flags->device,
                      "part of a device's name, or its index in `plume list devices`");
  command->add_flag("--validate", flags->validate,
                    "run with the Vulkan validation layer; any message makes the exit code 1");
  command->add_option("--shaders", flags->shaders,
                      "compile shaders from this folder instead of the embedded ones");
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
