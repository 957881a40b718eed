#include "sandbox/window/swapchain.h"

#include <fmt/format.h>

#include <algorithm>

#include "renderer/gpu/errors.h"

namespace plume {
namespace {

constexpr auto kUsage = vk::ImageUsageFlagBits::eColorAttachment | vk::ImageUsageFlagBits::eTransferDst;
constexpr uint64_t kPatienceNs =
    100'000'000;  // a hidden window may never get an image, and keys must still work

vk::SurfaceFormatKHR choose_format(const gpu::Device& device, const vk::raii::SurfaceKHR& surface) {
  if (!device.physical().getSurfaceSupportKHR(device.queue_family(), *surface))
    throw gpu::NoUsableDevice(
        fmt::format("device '{}' cannot show pictures in this window; choose another with "
                    "--device, see `plume list devices`",
                    device.info().name));
  if ((device.physical().getSurfaceCapabilitiesKHR(*surface).supportedUsageFlags & kUsage) != kUsage)
    throw gpu::NoUsableDevice(
        fmt::format("device '{}' cannot copy pictures into this window", device.info().name));
  for (const vk::SurfaceFormatKHR& offered : device.physical().getSurfaceFormatsKHR(*surface))
    if (offered.colorSpace == vk::ColorSpaceKHR::eSrgbNonlinear &&
        (offered.format == vk::Format::eB8G8R8A8Unorm || offered.format == vk::Format::eR8G8B8A8Unorm ||
         offered.format == vk::Format::eA8B8G8R8UnormPack32))
      return offered;
  throw gpu::NoUsableDevice(fmt::format(
      "device '{}' offers no UNORM format of 8 bits a channel for this window", device.info().name));
}

vk::Extent2D choose_extent(const vk::SurfaceCapabilitiesKHR& can, glm::uvec2 window) {
  if (can.currentExtent.width != UINT32_MAX)
    return can.currentExtent;  // else the window takes the picture's size
  return {std::clamp(window.x, can.minImageExtent.width, can.maxImageExtent.width),
          std::clamp(window.y, can.minImageExtent.height, can.maxImageExtent.height)};
}

vk::CompositeAlphaFlagBitsKHR choose_alpha(const vk::SurfaceCapabilitiesKHR& can) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const Alpha wanted : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied})
    if (can.supportedCompositeAlpha & wanted) return wanted;
  return Alpha::ePostMultiplied;
}

}  // namespace

Swapchain::Swapchain(gpu::Device& device, vk::raii::SurfaceKHR surface)
    : device_(device),
      surface_(std::move(surface)),
      format_(choose_format(device, surface_)),
      acquired_(device.vk().createFence({})) {}

/// False when there is no area to show.
bool Swapchain::fit(glm::uvec2 window_size) {
  if (!outdated_ && made_for_ == window_size) return true;
  const auto can = device_.physical().getSurfaceCapabilitiesKHR(*surface_);
  const vk::Extent2D extent = choose_extent(can, window_size);
  if (extent.width == 0 || extent.height == 0) return false;

  device_.vk().waitIdle();
  views_.clear();
  const uint32_t most = can.maxImageCount > 0 ? can.maxImageCount : UINT32_MAX;
  swapchain_ = device_.vk().createSwapchainKHR({.surface = *surface_,
                                                .minImageCount = std::min(can.minImageCount + 1, most),
                                                .imageFormat = format_.format,
                                                .imageColorSpace = format_.colorSpace,
                                                .imageExtent = extent,
                                                .imageArrayLayers = 1,
                                                .imageUsage = kUsage,
                                                .imageSharingMode = vk::SharingMode::eExclusive,
                                                .preTransform = can.currentTransform,
                                                .compositeAlpha = choose_alpha(can),
                                                .presentMode = vk::PresentModeKHR::eFifo,
                                                .clipped = VK_TRUE,
                                                .oldSwapchain = *swapchain_});
  device_.label(swapchain_, "window.swapchain");
  images_.clear();
  for (const VkImage image : swapchain_.getImages()) {
    images_.emplace_back(image);
    views_.push_back(device_.vk().createImageView(
        {.image = image,
         .viewType = vk::ImageViewType::e2D,
         .format = format_.format,
         .subresourceRange = {
             .aspectMask = vk::ImageAspectFlagBits::eColor, .levelCount = 1, .layerCount = 1}}));
    device_.label(views_.back(), fmt::format("window.image {}", views_.size() - 1));
  }
  extent_ = extent;
  made_for_ = window_size;
  outdated_ = false;
  return true;
}

bool Swapchain::show(glm::uvec2 window_size, const Record& record) try {
  if (!fit(window_size)) return false;
  const auto [acquired, index] = swapchain_.acquireNextImage(kPatienceNs, {}, *acquired_);
  if (acquired == vk::Result::eTimeout || acquired == vk::Result::eNotReady) return false;
  if (device_.vk().waitForFences(*acquired_, VK_TRUE, UINT64_MAX) != vk::Result::eSuccess)
    throw gpu::DeviceFailure("the window did not give its image");
  device_.vk().resetFences(*acquired_);

  const WindowImage image{.image = images_[index], .view = *views_[index], .extent = extent_};
  device_.immediate([&](const vk::raii::CommandBuffer& commands) { record(commands, image); });
  const vk::SwapchainKHR swapchain = *swapchain_;
  const vk::Result presented =
      device_.queue().presentKHR({.swapchainCount = 1, .pSwapchains = &swapchain, .pImageIndices = &index});
  outdated_ = acquired == vk::Result::eSuboptimalKHR || presented == vk::Result::eSuboptimalKHR;
  return true;
} catch (const vk::OutOfDateKHRError&) {  // resized between the question and the picture
  outdated_ = true;
  return false;
}

}  // namespace plume
