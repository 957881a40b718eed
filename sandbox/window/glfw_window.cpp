#include "sandbox/window/glfw_window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>

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

static_assert(int(Key::kEscape) == GLFW_KEY_ESCAPE && int(Key::kTab) == GLFW_KEY_TAB &&
              int(Key::kSpace) == GLFW_KEY_SPACE && int(key('M')) == GLFW_KEY_M &&
              int(Key::kRight) == GLFW_KEY_RIGHT && int(Key::kUp) == GLFW_KEY_UP &&
              int(Key::kHome) == GLFW_KEY_HOME && int(Key::kDelete) == GLFW_KEY_DELETE &&
              int(Key::kEnd) == GLFW_KEY_END && int(Key::kF1) == GLFW_KEY_F1 &&
              int(Key::kF12) == GLFW_KEY_F12 && int(Key::kLeftShift) == GLFW_KEY_LEFT_SHIFT &&
              int(Key::kRightAlt) == GLFW_KEY_RIGHT_ALT && int(Key::kRightControl) == GLFW_KEY_RIGHT_CONTROL);

/// The monitor that holds most of the window.
GLFWmonitor* monitor_of(GLFWwindow* window) {
  int x, y, width, height, count = 0;
  glfwGetWindowPos(window, &x, &y);
  glfwGetWindowSize(window, &width, &height);
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  GLFWmonitor* best = glfwGetPrimaryMonitor();
  int most = 0;
  for (int i = 0; i < count; ++i) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    int left, top;
    glfwGetMonitorPos(monitors[i], &left, &top);
    if (!mode) continue;
    const int wide = std::min(x + width, left + mode->width) - std::max(x, left);
    const int high = std::min(y + height, top + mode->height) - std::max(y, top);
    if (wide > 0 && high > 0 && wide * high > most) best = monitors[i], most = wide * high;
  }
  return best;
}

/// Whether enough of a window's upper edge is on some monitor to take hold of it.
bool is_reachable(glm::ivec2 corner, glm::uvec2 size) {
  constexpr int kGrip = 48;
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  return std::any_of(monitors, monitors + count, [&](GLFWmonitor* monitor) {
    const GLFWvidmode* mode = glfwGetVideoMode(monitor);
    int left, top;
    glfwGetMonitorPos(monitor, &left, &top);
    return mode && corner.x + int(size.x) > left + kGrip && corner.x + kGrip < left + mode->width &&
           corner.y >= top - kGrip && corner.y + kGrip < top + mode->height;
  });
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

void GlfwWindow::hear(GLFWwindow* window, const WindowEvent& event) {
  static_cast<InputQueue*>(glfwGetWindowUserPointer(window))->push(event, glfwGetTime());
}

GlfwWindow::GlfwWindow(const std::string& title, glm::uvec2 size, std::optional<glm::ivec2> corner) {
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);  // until it is in its place
  window_.reset(glfwCreateWindow(int(size.x), int(size.y), title.c_str(), nullptr, nullptr));
  if (!window_) refuse("no window can be opened");

  if (corner && is_reachable(*corner, size)) glfwSetWindowPos(window_.get(), corner->x, corner->y);
  glfwShowWindow(window_.get());
  glfwSetWindowSizeLimits(window_.get(), 320, 180, GLFW_DONT_CARE,
                          GLFW_DONT_CARE);  // panels must stay usable

  glfwSetWindowUserPointer(window_.get(), events_.get());
  glfwSetKeyCallback(window_.get(), [](GLFWwindow* window, int code, int, int action, int mods) {
    hear(window,
         KeyChanged{.press = {Key(code), (mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0},
                    .down = action != GLFW_RELEASE});
  });
  glfwSetCharCallback(window_.get(),
                      [](GLFWwindow* window, unsigned character) { hear(window, TextTyped{character}); });
  glfwSetMouseButtonCallback(window_.get(), [](GLFWwindow* window, int button, int action, int) {
    if (size_t(button) < kButtons)
      hear(window, ButtonChanged{.button = Button(button), .down = action == GLFW_PRESS});
  });
  glfwSetCursorPosCallback(window_.get(), [](GLFWwindow* window, double x, double y) {
    hear(window, PointerMoved{{x, y}});
  });
  glfwSetCursorEnterCallback(window_.get(), [](GLFWwindow* window, int inside) {
    double x = 0, y = 0;
    glfwGetCursorPos(window, &x, &y);
    inside ? hear(window, PointerMoved{{x, y}}) : hear(window, PointerLeft{});
  });
  glfwSetScrollCallback(window_.get(), [](GLFWwindow* window, double x, double y) {
    hear(window, WheelTurned{{x, y}});
  });
}

void GlfwWindow::set_full_screen(bool full_screen) {
  GLFWwindow* window = window_.get();
  if (full_screen == (glfwGetWindowMonitor(window) != nullptr)) return;
  if (!full_screen) {
    glfwSetWindowMonitor(window, nullptr, windowed_.x, windowed_.y, windowed_.z, windowed_.w, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = monitor_of(window);
  const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
  if (!mode) return;  // no monitor is connected
  glfwGetWindowPos(window, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window, &windowed_.z, &windowed_.w);
  glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

glm::ivec4 GlfwWindow::placement() const {
  if (glfwGetWindowMonitor(window_.get())) return windowed_;
  glm::ivec4 now;
  glfwGetWindowPos(window_.get(), &now.x, &now.y);
  glfwGetWindowSize(window_.get(), &now.z, &now.w);
  return now;
}

void GlfwWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(window_.get(), title.c_str());
}

float GlfwWindow::pixel_ratio() const {
  int width = 0, pixels = 0, height = 0;
  glfwGetWindowSize(window_.get(), &width, &height);
  glfwGetFramebufferSize(window_.get(), &pixels, &height);
  return width > 0 ? float(pixels) / float(width) : 1.0f;
}

float GlfwWindow::content_scale() const {
  float x = 1, y = 1;
  glfwGetWindowContentScale(window_.get(), &x, &y);
  return x;
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

WindowInput GlfwWindow::next_input() {
  WindowInput input = events_->take();
  // Whether it closes is for others to say.
  input.wants_to_close = glfwWindowShouldClose(window_.get());
  glfwSetWindowShouldClose(window_.get(), GLFW_FALSE);
  return input;
}

void GlfwWindow::wait(double seconds) {
  events_->look();
  if (seconds > 0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwPollEvents();
}

}  // namespace plume
