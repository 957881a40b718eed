// A window of the desktop: its surface for Vulkan, and what the user does in it. The one file that calls
// GLFW.
#ifndef PLUME_WINDOW_GLFW_WINDOW_H
#define PLUME_WINDOW_GLFW_WINDOW_H

#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/gpu/vulkan.h"
#include "sandbox/window/input_queue.h"

struct GLFWwindow;

namespace plume {

class GlfwWindow {
 public:
  /// Throws gpu::NoUsableDevice, with the commands that need no display, when there is none.
  /// `corner` is left to the desktop where there is none, or no monitor is there any more.
  GlfwWindow(const std::string& title, glm::uvec2 size, std::optional<glm::ivec2> corner = {});

  /// What a Vulkan instance must have for make_surface().
  std::vector<const char*> instance_extensions() const;
  vk::raii::SurfaceKHR make_surface(const vk::raii::Instance& instance) const;

  /// In pixels; 0x0 while it is minimised.
  glm::uvec2 size() const;
  /// Over the whole monitor it is on, or back to where it was.
  void set_full_screen(bool full_screen);
  /// Position and size while it is not full-screen, in screen coordinates.
  glm::ivec4 placement() const;
  void set_title(const std::string& title);
  // As next_input() left them.
  bool holds(Key key) const { return events_->holds(key); }
  bool holds(Button button) const { return events_->holds(button); }
  /// In screen coordinates from the upper left.
  glm::vec2 pointer() const { return events_->pointer(); }
  /// Where the left button went down last.
  glm::vec2 pressed_at() const { return events_->pressed_at(); }
  /// Pixels to a screen coordinate, and how much larger than on a common screen things should be drawn.
  float pixel_ratio() const;
  float content_scale() const;
  /// Sleeps until something happens, at most so long, and notes what did.
  void wait(double seconds);
  /// What was done since, step by step: see InputQueue.
  WindowInput next_input();
  bool has_input() const { return !events_->empty(); }
  GLFWwindow* handle() const { return window_.get(); }

 private:
  struct Library {  // glfwInit() and glfwTerminate()
    Library();
    ~Library();
    Library(const Library&) = delete;
  };
  struct Destroy {
    void operator()(GLFWwindow* window) const;
  };

  static void hear(GLFWwindow* window, const WindowEvent& event);

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  glm::ivec4 windowed_{0};  // position and size before it was full-screen
  std::unique_ptr<InputQueue> events_ = std::make_unique<InputQueue>();  // address handed to GLFW
};

}  // namespace plume
#endif
