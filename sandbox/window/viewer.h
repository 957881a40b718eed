// The workspace in a window: takes what the user does there, draws what has changed, shows it under the
// panels.
#ifndef PLUME_WINDOW_VIEWER_H
#define PLUME_WINDOW_VIEWER_H

#include <chrono>
#include <filesystem>
#include <functional>

#include "sandbox/debugger/panels.h"
#include "sandbox/window/overlay.h"
#include "sandbox/workspace/shader_watch.h"

namespace plume {

class Viewer {
 public:
  /// `shaders`: the folder that they are compiled from, which is watched; "": the embedded ones.
  Viewer(GlfwWindow& window, Workspace& workspace, std::filesystem::path shaders);
  ~Viewer();
  Viewer(const Viewer&) = delete;

  Interface& interface() { return interface_; }
  /// Until the user closes the window, or so many frames were shown (0: no such end). Once `interrupted` says
  /// so, it is as if the user had asked to close.
  void run(uint32_t frames, const std::function<bool()>& interrupted = {});
  /// Side A as it was last drawn, without the panels, as PNG. Throws when nothing was drawn, and FileError.
  void save_picture(const std::filesystem::path& path) const;
  /// See Crosshair: as if it had been placed by hand, and other methods been chosen.
  void place_crosshair(glm::dvec2 direction, std::vector<std::string> others);
  /// What the crosshair's panel shows, as `plume probe` prints it. Throws when it shows nothing, and
  /// FileError.
  void save_crosshair(const std::filesystem::path& path) const;

 private:
  void react_to(const WindowInput& input);
  void move_camera(const WindowInput& input);
  void fly(double seconds);
  void drag_divider(const WindowInput& input);
  void place_crosshair(glm::vec2 pointer);
  void react_to(const WindowInput::Click& click);
  void drag_effect(const WindowInput& input);
  void follow_shaders();
  void draw_what_is_due();
  void draw();
  bool moves() const;
  void note_whole();
  void note_overlay();
  bool show(const Notice* notice = nullptr);
  void tell(const gpu::Preparing& preparing);
  glm::uvec2 picture_area() const;
  double now_s() const;
  double idle_s() const;

  GlfwWindow& window_;
  Workspace& workspace_;
  Interface interface_;
  Swapchain swapchain_;
  Overlay overlay_;
  ShaderWatch shaders_;
  std::string shader_problem_;  // that is shown, or was
  Area area_{};                 // of the picture
  glm::uvec2 drawn_for_{0};
  bool is_drawn_ = false;  // what is set, to the end
  bool drags_divider_ = false, dragging_ = false;
  bool held_ = false;                 // a button, over the picture or over a panel
  bool starts_drag_ = true;           // nothing was dragged since the left button went down
  std::optional<glm::vec2> clicked_;  // and it may yet be a double click
  double clicked_s_ = 0;
  double last_s_ = 0, told_s_ = 0;
  double moved_s_ = 0;               // that the last picture was there
  double overlay_ms_ = 0;            // of the frame that is being shown
  std::vector<double> overlays_ms_;  // of the frames of this second
  double overlays_since_s_ = 0;
  std::array<vk::Image, 2> whole_{};  // displayed images that have been drawn to their end, of A and B
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace plume
#endif
