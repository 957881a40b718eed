// Buffers and images: move-only, labelled, their memory on their owner's account.
// Images stay in VK_IMAGE_LAYOUT_GENERAL all their life: passes are separated by full memory barriers, so one
// layout is one idea less, and drivers of today gain little from others (the reasoning of
// VK_KHR_unified_image_layouts).
#ifndef PLUME_GPU_RESOURCES_H
#define PLUME_GPU_RESOURCES_H

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "renderer/gpu/device.h"

namespace plume::gpu {

struct BufferDesc {
  std::string owner;          ///< account of the memory: "avboit", "simulation"
  std::string label;          ///< "extinction"
  vk::DeviceSize bytes = 0;   ///< at least 1
  bool host_visible = false;  ///< mapped for the host as long as it lives
};

class Buffer {
 public:
  Buffer() = default;
  Buffer(Device& device, const BufferDesc& desc);

  vk::Buffer vk() const { return *buffer_; }
  vk::DeviceSize bytes() const { return bytes_; }
  vk::DeviceAddress address() const { return address_; }
  /// As shaders take it where no 64-bit integers are: low word, high word.
  glm::uvec2 address_words() const { return {uint32_t(address_), uint32_t(address_ >> 32)}; }
  /// Host-visible buffers only.
  template <class T>
  std::span<T> mapped() const {
    return {static_cast<T*>(mapped_), size_t(bytes_ / sizeof(T))};
  }
  explicit operator bool() const { return bytes_ != 0; }

 private:
  Allocation allocation_;
  vk::raii::Buffer buffer_{nullptr};
  vk::DeviceSize bytes_ = 0;
  vk::DeviceAddress address_ = 0;
  void* mapped_ = nullptr;
};

/// A device buffer that holds `data`.
Buffer make_buffer(Device& device, std::string owner, std::string label, std::span<const std::byte> data);
template <class T>
Buffer make_buffer(Device& device, std::string owner, std::string label, const std::vector<T>& data) {
  return make_buffer(device, std::move(owner), std::move(label), std::as_bytes(std::span(data)));
}

struct ImageDesc {
  std::string owner, label;
  vk::Format format = vk::Format::eUndefined;
  vk::Extent3D extent{1, 1, 1};  ///< depth > 1 makes a 3-D image
  uint32_t layers = 0;           ///< 0: a plain 2-D image; otherwise an array of so many layers
  uint32_t samples = 1;          ///< a pixel: 1 or 4
  vk::ImageUsageFlags usage;     ///< transfer in both directions is always added
};

class Image {
 public:
  Image() = default;
  /// Contents are undefined until written.
  Image(Device& device, const ImageDesc& desc);

  vk::Image vk() const { return *image_; }
  vk::ImageView view() const { return *view_; }
  vk::Format format() const { return format_; }
  vk::Extent3D extent() const { return extent_; }
  uint32_t layers() const { return layers_; }
  uint32_t samples() const { return samples_; }
  vk::ImageAspectFlags aspect() const;
  explicit operator bool() const { return extent_.width != 0; }

 private:
  Allocation allocation_;
  vk::raii::Image image_{nullptr};
  vk::raii::ImageView view_{nullptr};
  vk::Format format_ = vk::Format::eUndefined;
  vk::Extent3D extent_{0, 0, 0};
  uint32_t layers_ = 1, samples_ = 1;
};

/// What was recorded so far may be read from mapped memory once the device has done it.
void make_visible_to_host(const vk::raii::CommandBuffer& commands);

/// Copies a whole buffer, or the first level and layer of an image, to the host. Waits for the device.
std::vector<std::byte> read_bytes(Device& device, const Buffer& buffer);
std::vector<std::byte> read_bytes(Device& device, const Image& image);

/// Copies texels, row by row, to a plain 2-D image. Waits for the device.
void write_bytes(Device& device, const Image& image, std::span<const std::byte> texels);

template <class T, class Resource>
std::vector<T> read(Device& device, const Resource& resource) {
  const auto bytes = read_bytes(device, resource);
  std::vector<T> result(bytes.size() / sizeof(T));
  std::memcpy(result.data(), bytes.data(), result.size() * sizeof(T));
  return result;
}

/// Bytes of one texel of the formats Plume reads back; throws std::invalid_argument for others.
uint32_t texel_bytes(vk::Format format);

}  // namespace plume::gpu
#endif
