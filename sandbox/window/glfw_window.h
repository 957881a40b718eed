// A window of the desktop: its surface for Vulkan, and what the user does in it. The one file that calls
// GLFW.
#ifndef PLUME_WINDOW_GLFW_WINDOW_H
#define PLUME_WINDOW_GLFW_WINDOW_H

#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "renderer/gpu/vulkan.h"

struct GLFWwindow;

namespace plume {

enum class Key { kSpace, kLeft, kRight, kM, kEscape };

/// What happened since the last time it was asked. Kept in full: a slow frame loses no key and no movement.
struct WindowInput {
  std::vector<Key> keys;  ///< pressed, or repeated while held
  glm::vec2 drag{0.0f};   ///< movement with the left button held, in screen coordinates
  float wheel = 0.0f;     ///< steps; up is positive
};

class GlfwWindow {
 public:
  /// Throws gpu::NoUsableDevice, with the commands that need no display, when there is none.
  GlfwWindow(const std::string& title, glm::uvec2 size);

  /// What a Vulkan instance must have for make_surface().
  std::vector<const char*> instance_extensions() const;
  vk::raii::SurfaceKHR make_surface(const vk::raii::Instance& instance) const;

  /// In pixels; 0x0 while it is minimised.
  glm::uvec2 size() const;
  bool closing() const;
  void close();
  /// Sleeps until something happens, at most so long.
  WindowInput wait(double seconds);
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

  struct Events {
    WindowInput input;
    glm::vec2 pointer{0.0f};
    bool dragging = false;
  };
  static Events& events_of(GLFWwindow* window);

  Library library_;
  std::unique_ptr<GLFWwindow, Destroy> window_;
  std::unique_ptr<Events> events_ = std::make_unique<Events>();  // address handed to GLFW
};

}  // namespace plume
#endif
