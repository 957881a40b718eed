#include "sandbox/window/glfw_window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <optional>
#include <utility>

#include "renderer/gpu/errors.h"

namespace plume {
namespace {

[[noreturn]] void refuse(const std::string& what) {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw gpu::NoUsableDevice(fmt::format(
      "{}{}{}; without a display, `plume compare SCENE` and `plume replay SCRIPT` draw into files", what,
      reason ? ": " : "", reason ? reason : ""));
}

std::optional<Key> key_of(int code) {
  switch (code) {
    case GLFW_KEY_SPACE:
      return Key::kSpace;
    case GLFW_KEY_LEFT:
      return Key::kLeft;
    case GLFW_KEY_RIGHT:
      return Key::kRight;
    case GLFW_KEY_M:
      return Key::kM;
    case GLFW_KEY_ESCAPE:
      return Key::kEscape;
    default:
      return std::nullopt;
  }
}

}  // namespace

GlfwWindow::Library::Library() {
  if (!glfwInit()) refuse("no window can be opened");
}
GlfwWindow::Library::~Library() {
  glfwTerminate();
}
void GlfwWindow::Destroy::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
}

GlfwWindow::Events& GlfwWindow::events_of(GLFWwindow* window) {
  return *static_cast<Events*>(glfwGetWindowUserPointer(window));
}

GlfwWindow::GlfwWindow(const std::string& title, glm::uvec2 size) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_.reset(glfwCreateWindow(int(size.x), int(size.y), title.c_str(), nullptr, nullptr));
  if (!window_) refuse("no window can be opened");

  glfwSetWindowSizeLimits(window_.get(), 320, 180, GLFW_DONT_CARE,
                          GLFW_DONT_CARE);  // panels must stay usable

  // The overlay's own callbacks come later and call these.
  glfwSetWindowUserPointer(window_.get(), events_.get());
  glfwSetKeyCallback(window_.get(), [](GLFWwindow* window, int code, int, int action, int) {
    const auto key = key_of(code);
    if (key && action != GLFW_RELEASE) events_of(window).input.keys.push_back(*key);
  });
  glfwSetMouseButtonCallback(window_.get(), [](GLFWwindow* window, int button, int action, int) {
    if (button == GLFW_MOUSE_BUTTON_LEFT) events_of(window).dragging = action == GLFW_PRESS;
  });
  glfwSetCursorPosCallback(window_.get(), [](GLFWwindow* window, double x, double y) {
    Events& e = events_of(window);
    const glm::vec2 here(x, y);
    if (e.dragging) e.input.drag += here - e.pointer;
    e.pointer = here;
  });
  glfwSetScrollCallback(
      window_.get(), [](GLFWwindow* window, double, double y) { events_of(window).input.wheel += float(y); });
}

std::vector<const char*> GlfwWindow::instance_extensions() const {
  uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names) refuse("Vulkan cannot draw to a window here");
  return {names, names + count};
}

vk::raii::SurfaceKHR GlfwWindow::make_surface(const vk::raii::Instance& instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(static_cast<VkInstance>(*instance), window_.get(), nullptr, &surface) !=
      VK_SUCCESS)
    refuse("Vulkan cannot draw to this window");
  return vk::raii::SurfaceKHR(instance, surface);
}

glm::uvec2 GlfwWindow::size() const {
  if (glfwGetWindowAttrib(window_.get(), GLFW_ICONIFIED)) return {0, 0};
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_.get(), &width, &height);
  return {uint32_t(width), uint32_t(height)};
}

bool GlfwWindow::closing() const {
  return glfwWindowShouldClose(window_.get());
}
void GlfwWindow::close() {
  glfwSetWindowShouldClose(window_.get(), GLFW_TRUE);
}

WindowInput GlfwWindow::wait(double seconds) {
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
  return std::exchange(events_->input, {});
}

}  // namespace plume
