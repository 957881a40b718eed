// The exact reference: every fragment captured per pixel in a linked list (Yang et al., EGSR 2010), sorted by
// (depth, card), composited in 32-bit float. It never truncates: a pool that is too small is grown and the
// frame drawn again.
#include "shaders/methods/reference.h"

#include <cstddef>

#include "renderer/methods/methods.h"

namespace plume {
namespace {

class Reference final : public Method {
 public:
  std::string_view id() const override { return "reference"; }
  Traits traits() const override {
    return {.title = "Exact reference",
            .source = "per-pixel linked lists, Yang et al. 2010; sorted by (depth, card), 32-bit composite",
            .transmission = "RGB, exact",
            .emission = "exact",
            .limits = "memory grows with the number of fragments; slow"};
  }

  Needs needs(glm::uvec2 size, const Transparents&) const override {
    return {.images = {},
            .buffers = {
                {.name = "heads", .bytes = uint64_t(size.x) * size.y * 4, .clear = shared::kListEnd},
                {.name = "pool", .bytes = sizeof(shared::FragmentPool), .clear = 0},
                {.name = "nodes", .bytes = uint64_t(capacity_) * sizeof(shared::FragmentNode), .clear = {}}}};
  }

  void record(const Picture& picture) override {
    const gpu::Buffer& pool = picture.resources.buffer("pool");
    const gpu::Buffer& heads = picture.resources.buffer("heads");
    const uint64_t nodes = picture.resources.buffer("nodes").address();

    picture.frame.pass("capture", [&](gpu::Pass& pass) {
      pass.update(
          pool, shared::FragmentPool{
                    .count = 0, .capacity = capacity_, .address = {uint32_t(nodes), uint32_t(nodes >> 32)}});
      pass.barrier();
      picture.transparents.draw(pass, {.fragment = "methods/reference_capture.frag",
                                       .targets = {},
                                       .depth_test = &picture.opaque_depth,
                                       .opaque_depth = &picture.opaque_depth,
                                       .area = picture.area(),
                                       .constants = {},
                                       .bindings = {{"Pool", &pool}, {"Heads", &heads}}});
    });
    picture.frame.pass("composite", [&](gpu::Pass& pass) {
      pass.dispatch(pass.pipelines().compute("methods/reference_composite.comp"),
                    {{"Pool", &pool},
                     {"Heads", &heads},
                     {"opaque_color", &picture.opaque_color},
                     {"result", &picture.result}},
                    picture.size, {gpu::groups(picture.size.x, 8), gpu::groups(picture.size.y, 8), 1});
    });
  }

  bool must_redraw(gpu::Device& device, const Resources& resources) override {
    const auto pool = gpu::read<shared::FragmentPool>(device, resources.buffer("pool"))[0];
    if (pool.count <= pool.capacity) return false;
    capacity_ = pool.count + pool.count / 8;  // room for the next frame of a growing effect
    return true;
  }

 private:
  uint32_t capacity_ = 1u << 16;
};

}  // namespace

std::unique_ptr<Method> make_reference() {
  return std::make_unique<Reference>();
}

}  // namespace plume
