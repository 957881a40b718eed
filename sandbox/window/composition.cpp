#include "sandbox/window/composition.h"

#include <algorithm>
#include <cmath>

namespace plume {
namespace {

constexpr vk::ClearColorValue kGround{std::array{0.07f, 0.07f, 0.075f, 1.0f}};
constexpr vk::ImageSubresourceRange kWhole{
    .aspectMask = vk::ImageAspectFlagBits::eColor, .levelCount = 1, .layerCount = 1};

void change_layout(const vk::raii::CommandBuffer& commands, vk::ImageMemoryBarrier2 barrier) {
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.subresourceRange = kWhole;
  commands.pipelineBarrier2({.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier});
}

/// Nothing of the picture may fall outside of the window's image.
void copy(const vk::raii::CommandBuffer& commands, const PlacedPicture& placed, const WindowImage& window) {
  const auto [width, height] = placed.at.extent;
  const int32_t right = std::min<int32_t>(placed.at.offset.x + int32_t(width), int32_t(window.extent.width));
  const int32_t bottom =
      std::min<int32_t>(placed.at.offset.y + int32_t(height), int32_t(window.extent.height));
  if (right <= placed.at.offset.x || bottom <= placed.at.offset.y) return;
  const double shown_x = double(right - placed.at.offset.x) / double(width);
  const double shown_y = double(bottom - placed.at.offset.y) / double(height);
  const auto& extent = placed.picture->extent();
  const int32_t from = int32_t(std::lround(double(placed.from) * extent.width));
  const int32_t to = int32_t(std::lround((placed.from + (placed.to - placed.from) * shown_x) * extent.width));
  const int32_t rows = int32_t(std::lround(shown_y * extent.height));
  if (to <= from || rows <= 0) return;
  const vk::ImageSubresourceLayers layers{.aspectMask = vk::ImageAspectFlagBits::eColor, .layerCount = 1};
  commands.blitImage(
      placed.picture->vk(), vk::ImageLayout::eGeneral, window.image, vk::ImageLayout::eTransferDstOptimal,
      vk::ImageBlit{.srcSubresource = layers,
                    .srcOffsets = std::array{vk::Offset3D{from, 0, 0}, vk::Offset3D{to, rows, 1}},
                    .dstSubresource = layers,
                    .dstOffsets = std::array{vk::Offset3D{placed.at.offset.x, placed.at.offset.y, 0},
                                             vk::Offset3D{right, bottom, 1}}},
      vk::Filter::eLinear);
}

}  // namespace

void record_composition(const vk::raii::CommandBuffer& commands, std::span<const PlacedPicture> pictures,
                        const WindowImage& window) {
  // The host waited for the pictures and for the window's image, so nothing comes before this.
  change_layout(commands, {.dstStageMask = vk::PipelineStageFlagBits2::eAllTransfer,
                           .dstAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .oldLayout = vk::ImageLayout::eUndefined,
                           .newLayout = vk::ImageLayout::eTransferDstOptimal,
                           .image = window.image});
  commands.clearColorImage(window.image, vk::ImageLayout::eTransferDstOptimal, kGround, kWhole);
  change_layout(commands, {.srcStageMask = vk::PipelineStageFlagBits2::eAllTransfer,
                           .srcAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .dstStageMask = vk::PipelineStageFlagBits2::eAllTransfer,
                           .dstAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .oldLayout = vk::ImageLayout::eTransferDstOptimal,
                           .newLayout = vk::ImageLayout::eTransferDstOptimal,
                           .image = window.image});
  for (const PlacedPicture& placed : pictures) copy(commands, placed, window);
  change_layout(commands, {.srcStageMask = vk::PipelineStageFlagBits2::eAllTransfer,
                           .srcAccessMask = vk::AccessFlagBits2::eTransferWrite,
                           .dstStageMask = vk::PipelineStageFlagBits2::eColorAttachmentOutput,
                           .dstAccessMask = vk::AccessFlagBits2::eColorAttachmentRead |
                                            vk::AccessFlagBits2::eColorAttachmentWrite,
                           .oldLayout = vk::ImageLayout::eTransferDstOptimal,
                           .newLayout = vk::ImageLayout::eColorAttachmentOptimal,
                           .image = window.image});
}

}  // namespace plume
