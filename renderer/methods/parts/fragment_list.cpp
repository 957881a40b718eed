#include "renderer/methods/parts/fragment_list.h"

#include <cstddef>

namespace plume::fragment_list {
void add_needs(Needs& needs, glm::uvec2 size, uint32_t capacity) {
  needs.buffers.push_back(
      {.name = "heads", .bytes = uint64_t(size.x) * size.y * 4, .clear = shared::kListEnd});
  needs.buffers.push_back({.name = "pool", .bytes = sizeof(shared::FragmentPool), .clear = 0});
  needs.buffers.push_back(
      {.name = "nodes", .bytes = uint64_t(capacity) * sizeof(shared::FragmentNode), .clear = {}});
}

void reset(gpu::Pass& pass, const Resources& resources, uint32_t capacity, const gpu::Buffer* extras) {
  pass.update(resources.buffer("pool"),
              shared::FragmentPool{.count = 0,
                                   .capacity = capacity,
                                   .address = resources.buffer("nodes").address_words(),
                                   .extras = extras ? extras->address_words() : glm::uvec2(0)});
}

gpu::Bindings bindings(const Resources& resources) {
  return {{"Pool", &resources.buffer("pool")}, {"Heads", &resources.buffer("heads")}};
}

void record_composite(const Picture& picture, const gpu::Image& background, bool redrawn) {
  gpu::Bindings bound = bindings(picture.resources);
  bound.push_back({"background", &background});
  bound.push_back({"result", &picture.result});
  picture.frame.pass("composite", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute("methods/parts/fragment_list/composite.comp", {redrawn ? 1u : 0u}),
                  bound, picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
  });
}

shared::FragmentPool pool(gpu::Device& device, const Resources& resources) {
  return gpu::read<shared::FragmentPool>(device, resources.buffer("pool"))[0];
}

bool grow(gpu::Device& device, const Resources& resources, uint32_t& capacity) {
  const shared::FragmentPool last = pool(device, resources);
  if (last.count <= last.capacity) return false;
  capacity = last.count + last.count / 8;  // room for the next frame of a growing effect
  return true;
}

}  // namespace plume::fragment_list
