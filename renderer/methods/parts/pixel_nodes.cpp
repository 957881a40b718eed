#include "renderer/methods/parts/pixel_nodes.h"

namespace plume::pixel_nodes {
std::vector<std::string> missing(const gpu::Device& device, Lock lock) {
  if (lock != Lock::kInterlock || device.has_fragment_interlock()) return {};
  return {"fragmentShaderPixelInterlock, or lock=spinlock"};
}

std::string insert_shader(const std::string& folder, Lock lock) {
  return folder + "/insert_" + std::string(kLocks[size_t(lock)]) + ".frag";
}

void add_needs(Needs& needs, glm::uvec2 size, uint32_t nodes, const Kind& kind) {
  const uint64_t pixels = uint64_t(size.x) * size.y, all = pixels * nodes;
  needs.buffers.push_back({.name = "turns", .bytes = pixels * 4, .clear = 0});
  needs.buffers.push_back({.name = "arrays", .bytes = sizeof(shared::NodeArrays), .clear = {}});
  needs.buffers.push_back({.name = "keys",
                           .bytes = all * sizeof(glm::uvec2),
                           .clear = kind.empty_keys ? std::optional(~0u) : std::nullopt});
  needs.buffers.push_back({.name = "through", .bytes = all * sizeof(glm::vec3), .clear = {}});
  if (kind.light) needs.buffers.push_back({.name = "light", .bytes = all * sizeof(glm::vec3), .clear = {}});
  needs.buffers.push_back({.name = "overflow", .bytes = sizeof(shared::NodeOverflow), .clear = 0});
}

void reset(gpu::Pass& pass, const Resources& resources, const Kind& kind) {
  pass.update(
      resources.buffer("arrays"),
      shared::NodeArrays{.keys = resources.buffer("keys").address_words(),
                         .through = resources.buffer("through").address_words(),
                         .light = kind.light ? resources.buffer("light").address_words() : glm::uvec2(0)});
}

gpu::Bindings bindings(const Resources& resources) {
  return {{"Turns", &resources.buffer("turns")},
          {"Arrays", &resources.buffer("arrays")},
          {"Overflow", &resources.buffer("overflow")}};
}

void draw(gpu::Pass& pass, const Picture& picture, uint32_t nodes, Transparents::Style style) {
  style.depth_test = style.opaque_depth = &picture.opaque_depth;
  style.area = picture.area();
  style.constants = {nodes};
  style.bindings = bindings(picture.resources);
  picture.transparents.draw(pass, style);
}

shared::NodeOverflow overflow(gpu::Device& device, const Resources& resources) {
  return gpu::read<shared::NodeOverflow>(device, resources.buffer("overflow"))[0];
}

}  // namespace plume::pixel_nodes
