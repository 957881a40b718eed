#include "renderer/methods/method.h"

namespace plume {
namespace {

vk::Extent3D extent_of(const ImageNeed& need, glm::uvec2 size) {
  return {(size.x + need.divisor - 1) / need.divisor, (size.y + need.divisor - 1) / need.divisor, need.depth};
}

}  // namespace

Transparents::Style front_of_opaque(const Picture& picture) {
  return {.fragment = "",
          .targets = {},
          .depth_test = &picture.opaque_depth,
          .opaque_depth = &picture.opaque_depth,
          .area = picture.area(),
          .constants = {},
          .bindings = {}};
}

uint64_t bytes_of(const Needs& needs, glm::uvec2 size) {
  uint64_t bytes = 0;
  for (const ImageNeed& need : needs.images) {
    const vk::Extent3D extent = extent_of(need, size);
    bytes += uint64_t(extent.width) * extent.height * extent.depth * std::max(need.layers, 1u) *
             need.samples * gpu::texel_bytes(need.format);
  }
  for (const BufferNeed& need : needs.buffers) bytes += need.bytes;
  return bytes;
}

void Resources::fit(gpu::Device& device, const std::string& owner, const Needs& needs, glm::uvec2 size) {
  std::map<std::string, gpu::Image> images;
  for (const ImageNeed& need : needs.images) {
    const vk::Extent3D extent = extent_of(need, size);
    auto old = images_.find(need.name);
    const bool fits = old != images_.end() && old->second.format() == need.format &&
                      old->second.extent() == extent && old->second.layers() == std::max(need.layers, 1u) &&
                      old->second.samples() == need.samples;
    images[need.name] = fits ? std::move(old->second)
                             : gpu::Image(device, {.owner = owner,
                                                   .label = need.name,
                                                   .format = need.format,
                                                   .extent = extent,
                                                   .layers = need.layers,
                                                   .samples = need.samples,
                                                   .usage = need.usage});
  }
  std::map<std::string, gpu::Buffer> buffers;
  for (const BufferNeed& need : needs.buffers) {
    auto old = buffers_.find(need.name);
    const bool fits = old != buffers_.end() && old->second.bytes() == need.bytes;
    buffers[need.name] = fits
                             ? std::move(old->second)
                             : gpu::Buffer(device, {.owner = owner, .label = need.name, .bytes = need.bytes});
  }
  images_ = std::move(images);
  buffers_ = std::move(buffers);
}

}  // namespace plume
