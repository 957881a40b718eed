#include "sandbox/window/picture_copy.h"

namespace plume {
namespace {

std::array<vk::Offset3D, 2> whole(vk::Extent2D extent) {
  return {vk::Offset3D{0, 0, 0}, vk::Offset3D{int32_t(extent.width), int32_t(extent.height), 1}};
}

void change_layout(const vk::raii::CommandBuffer& commands, vk::ImageMemoryBarrier2 barrier) {
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.subresourceRange = {
      .aspectMask = vk::ImageAspectFlagBits::eColor, .levelCount = 1, .layerCount = 1};
  commands.pipelineBarrier2({.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier});
}

}  // namespace

void record_picture_copy(const vk::raii::CommandBuffer& commands, const gpu::Image& picture,
                         const WindowImage& window) {
  // The host waited for the picture and for the window's image, so nothing comes before the copy.
  change_layout(commands, {.dstStageMask = vk::PipelineStageFlagBits2::eBlit,
                           .dstAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .oldLayout = vk::ImageLayout::eUndefined,
                           .newLayout = vk::ImageLayout::eTransferDstOptimal,
                           .image = window.image});
  const vk::ImageSubresourceLayers layers{.aspectMask = vk::ImageAspectFlagBits::eColor, .layerCount = 1};
  commands.blitImage(picture.vk(), vk::ImageLayout::eGeneral, window.image,
                     vk::ImageLayout::eTransferDstOptimal,
                     vk::ImageBlit{.srcSubresource = layers,
                                   .srcOffsets = whole({picture.extent().width, picture.extent().height}),
                                   .dstSubresource = layers,
                                   .dstOffsets = whole(window.extent)},
                     vk::Filter::eLinear);
  change_layout(commands, {.srcStageMask = vk::PipelineStageFlagBits2::eBlit,
                           .srcAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .dstStageMask = vk::PipelineStageFlagBits2::eColorAttachmentOutput,
                           .dstAccessMask = vk::AccessFlagBits2::eColorAttachmentRead |
                                            vk::AccessFlagBits2::eColorAttachmentWrite,
                           .oldLayout = vk::ImageLayout::eTransferDstOptimal,
                           .newLayout = vk::ImageLayout::eColorAttachmentOptimal,
                           .image = window.image});
}

}  // namespace plume
