// One scene in the window: plays it, lets the user look around and change the method, and draws what has
// changed.
#ifndef PLUME_WINDOW_VIEWER_H
#define PLUME_WINDOW_VIEWER_H

#include <chrono>
#include <filesystem>

#include "sandbox/measure/timing_history.h"
#include "sandbox/scene/stage.h"
#include "sandbox/window/overlay.h"
#include "sandbox/window/playback.h"

namespace plume {

class Viewer {
 public:
  Viewer(GlfwWindow& window, gpu::Device& device, gpu::Pipelines& pipelines, const PresetLibrary& library,
         Scene scene, const Playback& playback);

  /// Until the user closes the window, or so many frames were shown (0: no such end).
  void run(uint32_t frames);
  /// The scene as it was last drawn, without the panels, as PNG. Throws when nothing was drawn, and
  /// FileError.
  void save_picture(const std::filesystem::path& path) const;

 private:
  void react_to(const WindowInput& input);
  void press(Key key);
  void next_method();
  void describe_panels();
  /// Leaves the old method without memory, and its times behind.
  void method_changed(size_t before);
  void draw_scene();
  bool show();
  double now_s() const;
  double idle_s() const;

  GlfwWindow& window_;
  gpu::Device& device_;
  gpu::Pipelines& pipelines_;
  Stage stage_;
  Swapchain swapchain_;
  Overlay overlay_;

  std::vector<MethodInstance> methods_;  ///< all there are, so that each keeps its settings
  size_t current_ = 0;
  Playback playback_;
  std::optional<CameraKey> camera_;  ///< nothing: the scene's own
  std::optional<Targets> targets_;
  bool outdated_ = true;  ///< the picture no longer shows what is set
  bool always_draw_ = false;
  TimingHistory timings_;
  double frame_ms_ = 0, last_drawn_s_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace plume
#endif
