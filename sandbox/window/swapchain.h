// The images that the window shows. One is drawn at a time and waited for, so there are no semaphores: the
// host knows when an image is free and when it is done.
#ifndef PLUME_WINDOW_SWAPCHAIN_H
#define PLUME_WINDOW_SWAPCHAIN_H

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "renderer/gpu/device.h"

namespace plume {

struct WindowImage {
  vk::Image image;
  vk::ImageView view;
  vk::Extent2D extent;
};

class Swapchain {
 public:
  /// Throws NoUsableDevice when the device cannot show pictures in a window of this surface.
  Swapchain(gpu::Device& device, vk::raii::SurfaceKHR surface);

  /// 8 bits a channel and no conversion: the picture is sRGB-encoded already.
  vk::Format format() const { return format_.format; }

  /// Finds the image's content undefined and leaves it in layout PRESENT_SRC.
  using Record = std::function<void(const vk::raii::CommandBuffer&, const WindowImage&)>;
  /// Draws and shows one image of a window of `window_size`. False when the window cannot show anything just
  /// now: it was resized meanwhile, is minimised or hidden. The next call finds out anew.
  bool show(glm::uvec2 window_size, const Record& record);

 private:
  bool fit(glm::uvec2 window_size);

  gpu::Device& device_;
  vk::raii::SurfaceKHR surface_;
  vk::SurfaceFormatKHR format_;
  vk::raii::SwapchainKHR swapchain_{nullptr};
  vk::raii::Fence acquired_;
  std::vector<vk::Image> images_;
  std::vector<vk::raii::ImageView> views_;
  vk::Extent2D extent_{0, 0};
  glm::uvec2 made_for_{0, 0};
  bool outdated_ = true;
};

}  // namespace plume
#endif
