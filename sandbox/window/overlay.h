// Dear ImGui over the window's image: made, fed and drawn here; what is in the panels comes from
// sandbox/debugger/.
#ifndef PLUME_WINDOW_OVERLAY_H
#define PLUME_WINDOW_OVERLAY_H

#include "sandbox/window/glfw_window.h"
#include "sandbox/window/swapchain.h"

namespace plume {

class Overlay {
 public:
  /// Draws into images of `format`.
  Overlay(gpu::Device& device, const GlfwWindow& window, vk::Format format);

  /// ImGui's panels may be described between the two.
  void begin();
  void end();
  /// Whether the pointer, or the keyboard, is busy in a panel; asked after begin().
  bool takes_pointer() const;
  bool takes_keys() const;

  /// Draws what was last described over `image`, and leaves that ready to be shown. The image must be in
  /// COLOR_ATTACHMENT_OPTIMAL; the commands must be waited for before the next call.
  void record(const vk::raii::CommandBuffer& commands, const WindowImage& image);

 private:
  struct Context {
    Context();
    ~Context();
    Context(const Context&) = delete;
  };
  struct WindowBackend {
    explicit WindowBackend(const GlfwWindow& window);
    ~WindowBackend();
    WindowBackend(const WindowBackend&) = delete;
  };
  struct VulkanBackend {
    VulkanBackend(gpu::Device& device, vk::DescriptorPool pool, vk::RenderPass render_pass);
    ~VulkanBackend();
    VulkanBackend(const VulkanBackend&) = delete;
  };

  gpu::Device& device_;
  vk::raii::RenderPass render_pass_;
  vk::raii::DescriptorPool descriptors_;
  vk::raii::Framebuffer framebuffer_{nullptr};
  Context context_;
  WindowBackend window_backend_;
  VulkanBackend vulkan_backend_;
};

}  // namespace plume
#endif
