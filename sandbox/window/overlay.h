// Dear ImGui over the window's image: made, fed and drawn here; what is in the panels comes from
// sandbox/debugger/.
#ifndef PLUME_WINDOW_OVERLAY_H
#define PLUME_WINDOW_OVERLAY_H

#include <optional>
#include <span>

#include "sandbox/debugger/preset_gallery.h"
#include "sandbox/window/glfw_window.h"
#include "sandbox/window/swapchain.h"

namespace plume {

/// Told over the panels as they were last described.
struct Notice {
  std::string text;
  float share = 0;   ///< of the work that is done
  glm::vec2 middle;  ///< where, in ImGui's coordinates
};

class Overlay {
 public:
  /// Draws into images of `format`. Without a window, whoever describes panels sets ImGui's DisplaySize and
  /// DeltaTime.
  Overlay(gpu::Device& device, const GlfwWindow* window, vk::Format format);

  /// ImGui's panels may be described between the two. `text_scale` is of the text and all around it, in
  /// ImGui's coordinates, each of which is `pixel_ratio` pixels. Pictures that the gallery wants are seen
  /// from now on.
  void begin(float text_scale, float pixel_ratio, const WindowInput& input, PresetGallery& gallery);
  void end();
  /// Whether the pointer, or the keyboard, is busy in a panel; asked after begin().
  bool takes_pointer() const;
  bool takes_keys() const;

  /// Draws what was last described over `image`, and leaves that ready to be shown. The image must be in
  /// COLOR_ATTACHMENT_OPTIMAL; the commands must be waited for before the next call.
  void record(const vk::raii::CommandBuffer& commands, const WindowImage& image, const Notice* notice = {});
  /// Whether something was described that can be drawn: not between begin() and end().
  bool is_whole() const;

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
    VulkanBackend(gpu::Device& device, vk::RenderPass render_pass);
    ~VulkanBackend();
    VulkanBackend(const VulkanBackend&) = delete;
    vk::raii::DescriptorPool descriptors;
  };
  void fit_text(float scale, float pixel_ratio, PresetGallery& gallery);

  gpu::Device& device_;
  vk::raii::RenderPass render_pass_;
  vk::raii::Framebuffer framebuffer_{nullptr};
  Context context_;
  std::optional<WindowBackend> window_backend_;
  std::optional<VulkanBackend> vulkan_backend_;  // made anew with the font's texture
  float text_scale_ = 0, pixel_ratio_ = 0;
  bool list_is_open_ = false;
};

}  // namespace plume
#endif
