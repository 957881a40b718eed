#include "renderer/gpu/resources.h"

#include <fmt/format.h>

#include <cstring>
#include <stdexcept>

#include "renderer/gpu/errors.h"

namespace plume::gpu {
namespace {

constexpr vk::ImageSubresourceRange whole(vk::ImageAspectFlags aspect) {
  return {
      .aspectMask = aspect, .levelCount = VK_REMAINING_MIP_LEVELS, .layerCount = VK_REMAINING_ARRAY_LAYERS};
}

Buffer staging_buffer(Device& device, vk::DeviceSize bytes) {
  return Buffer(device, {.owner = "staging", .label = "staging", .bytes = bytes, .host_visible = true});
}

Allocation allocate(Device& device, const vk::MemoryRequirements& needs, bool host_visible,
                    bool device_address, const std::string& owner, const std::string& label) try {
  return device.memory().allocate(needs, host_visible, device_address, owner, label);
} catch (const DeviceFailure& failure) {
  throw DeviceFailure(fmt::format("{}; the last pass was '{}'", failure.what(), device.last_pass()));
}

}  // namespace

void make_visible_to_host(const vk::raii::CommandBuffer& commands) {
  const vk::MemoryBarrier2 barrier{.srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                   .srcAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                                   .dstStageMask = vk::PipelineStageFlagBits2::eHost,
                                   .dstAccessMask = vk::AccessFlagBits2::eHostRead};
  commands.pipelineBarrier2({.memoryBarrierCount = 1, .pMemoryBarriers = &barrier});
}

Buffer::Buffer(Device& device, const BufferDesc& desc) : bytes_(desc.bytes) {
  using Usage = vk::BufferUsageFlagBits;
  buffer_ = device.vk().createBuffer({.size = desc.bytes,
                                      .usage = Usage::eStorageBuffer | Usage::eUniformBuffer |
                                               Usage::eIndirectBuffer | Usage::eTransferSrc |
                                               Usage::eTransferDst | Usage::eShaderDeviceAddress});
  allocation_ =
      allocate(device, buffer_.getMemoryRequirements(), desc.host_visible, true, desc.owner, desc.label);
  buffer_.bindMemory(*allocation_.memory(), 0);
  address_ = device.vk().getBufferAddress({.buffer = *buffer_});
  if (desc.host_visible) mapped_ = allocation_.memory().mapMemory(0, VK_WHOLE_SIZE);
  device.label(buffer_, desc.owner + "." + desc.label);
}

Buffer make_buffer(Device& device, std::string owner, std::string label, std::span<const std::byte> data) {
  const Buffer staging = staging_buffer(device, std::max<size_t>(data.size(), 1));
  std::memcpy(staging.mapped<std::byte>().data(), data.data(), data.size());
  Buffer result(device, {.owner = std::move(owner), .label = std::move(label), .bytes = staging.bytes()});
  device.immediate([&](const vk::raii::CommandBuffer& commands) {
    commands.copyBuffer(staging.vk(), result.vk(), vk::BufferCopy{.size = staging.bytes()});
  });
  return result;
}

Image::Image(Device& device, const ImageDesc& desc)
    : format_(desc.format), extent_(desc.extent), layers_(std::max(desc.layers, 1u)), samples_(desc.samples) {
  const bool volume = desc.extent.depth > 1;
  image_ = device.vk().createImage(
      {.imageType = volume ? vk::ImageType::e3D : vk::ImageType::e2D,
       .format = desc.format,
       .extent = desc.extent,
       .mipLevels = 1,
       .arrayLayers = layers_,
       .samples = vk::SampleCountFlagBits(desc.samples),
       .tiling = vk::ImageTiling::eOptimal,
       .usage = desc.usage | vk::ImageUsageFlagBits::eTransferSrc | vk::ImageUsageFlagBits::eTransferDst});
  allocation_ = allocate(device, image_.getMemoryRequirements(), false, false, desc.owner, desc.label);
  image_.bindMemory(*allocation_.memory(), 0);
  view_ = device.vk().createImageView({.image = *image_,
                                       .viewType = volume            ? vk::ImageViewType::e3D
                                                   : desc.layers > 0 ? vk::ImageViewType::e2DArray
                                                                     : vk::ImageViewType::e2D,
                                       .format = desc.format,
                                       .subresourceRange = whole(aspect())});
  device.label(image_, desc.owner + "." + desc.label);
  device.label(view_, desc.owner + "." + desc.label);
  device.immediate([&](const vk::raii::CommandBuffer& commands) {
    const vk::ImageMemoryBarrier2 barrier{.srcStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                          .dstStageMask = vk::PipelineStageFlagBits2::eAllCommands,
                                          .dstAccessMask = vk::AccessFlagBits2::eMemoryWrite,
                                          .oldLayout = vk::ImageLayout::eUndefined,
                                          .newLayout = vk::ImageLayout::eGeneral,
                                          .image = *image_,
                                          .subresourceRange = whole(aspect())};
    commands.pipelineBarrier2({.imageMemoryBarrierCount = 1, .pImageMemoryBarriers = &barrier});
  });
}

vk::ImageAspectFlags Image::aspect() const {
  return format_ == vk::Format::eD32Sfloat ? vk::ImageAspectFlagBits::eDepth
                                           : vk::ImageAspectFlagBits::eColor;
}

uint32_t texel_bytes(vk::Format format) {
  switch (format) {
    case vk::Format::eR8Unorm:
      return 1;
    case vk::Format::eR16Sfloat:
    case vk::Format::eR16Unorm:
      return 2;
    case vk::Format::eR8G8B8A8Unorm:
    case vk::Format::eR8G8B8A8Srgb:
    case vk::Format::eB10G11R11UfloatPack32:
    case vk::Format::eA2B10G10R10UnormPack32:
    case vk::Format::eR16G16Sfloat:
    case vk::Format::eR32Sfloat:
    case vk::Format::eR32Uint:
    case vk::Format::eD32Sfloat:
      return 4;
    case vk::Format::eR16G16B16A16Sfloat:
    case vk::Format::eR32G32Sfloat:
    case vk::Format::eR32G32Uint:
      return 8;
    case vk::Format::eR32G32B32A32Sfloat:
      return 16;
    default:
      throw std::invalid_argument("no texel size known for " + vk::to_string(format));
  }
}

std::vector<std::byte> read_bytes(Device& device, const Buffer& buffer) {
  const Buffer staging = staging_buffer(device, buffer.bytes());
  device.immediate([&](const vk::raii::CommandBuffer& commands) {
    commands.copyBuffer(buffer.vk(), staging.vk(), vk::BufferCopy{.size = buffer.bytes()});
    make_visible_to_host(commands);
  });
  const auto mapped = staging.mapped<std::byte>();
  return {mapped.begin(), mapped.end()};
}

std::vector<std::byte> read_bytes(Device& device, const Image& image) {
  const auto extent = image.extent();
  const Buffer staging = staging_buffer(
      device, vk::DeviceSize(extent.width) * extent.height * extent.depth * texel_bytes(image.format()));
  device.immediate([&](const vk::raii::CommandBuffer& commands) {
    commands.copyImageToBuffer(
        image.vk(), vk::ImageLayout::eGeneral, staging.vk(),
        vk::BufferImageCopy{.imageSubresource = {.aspectMask = image.aspect(), .layerCount = 1},
                            .imageExtent = extent});
    make_visible_to_host(commands);
  });
  const auto mapped = staging.mapped<std::byte>();
  return {mapped.begin(), mapped.end()};
}

void write_bytes(Device& device, const Image& image, std::span<const std::byte> texels) {
  const auto extent = image.extent();
  if (texels.size() != size_t(extent.width) * extent.height * texel_bytes(image.format()))
    throw std::invalid_argument(
        fmt::format("{} bytes do not fill an image of {}x{}", texels.size(), extent.width, extent.height));
  const Buffer staging = staging_buffer(device, texels.size());
  std::memcpy(staging.mapped<std::byte>().data(), texels.data(), texels.size());
  device.immediate([&](const vk::raii::CommandBuffer& commands) {
    commands.copyBufferToImage(
        staging.vk(), image.vk(), vk::ImageLayout::eGeneral,
        vk::BufferImageCopy{.imageSubresource = {.aspectMask = image.aspect(), .layerCount = 1},
                            .imageExtent = extent});
  });
}

}  // namespace plume::gpu
