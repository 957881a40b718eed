#include "renderer/drawn_pixel.h"

#include <algorithm>
#include <tuple>

#include "shaders/shared/view.h"

namespace plume {
namespace {

constexpr uint32_t kFirstCapacity = 1024;  // fragments

}  // namespace

std::vector<shared::ProbedFragment> fragments_at(gpu::Device& device, gpu::Pipelines& pipelines,
                                                 const Targets& targets, const Transparents& transparents,
                                                 glm::uvec2 pixel) {
  using shared::ProbedCount, shared::ProbedFragment;
  for (uint32_t capacity = kFirstCapacity;;) {
    const gpu::Buffer found(device, {.owner = "probe",
                                     .label = "fragments",
                                     .bytes = sizeof(ProbedCount) + capacity * sizeof(ProbedFragment)});
    gpu::Frame frame(device, pipelines);
    frame.pass("fragments", [&](gpu::Pass& pass) {
      pass.update(found, ProbedCount{.count = 0, .capacity = capacity});
      pass.barrier();
      transparents.draw(pass, {.fragment = "probe/fragments.frag",
                               .targets = {},
                               .depth_test = &targets.opaque_depth,
                               .opaque_depth = &targets.opaque_depth,
                               .area = {targets.size.x, targets.size.y},
                               .pixel = pixel,
                               .constants = {},
                               .bindings = {{"ProbedFragments", &found}}});
    });
    frame.finish();
    const auto bytes = gpu::read_bytes(device, found);
    ProbedCount head;
    std::memcpy(&head, bytes.data(), sizeof(head));
    if (head.count > capacity) {
      capacity = head.count;
      continue;
    }
    std::vector<ProbedFragment> fragments(head.count);
    if (!fragments.empty())
      std::memcpy(fragments.data(), bytes.data() + sizeof(head), head.count * sizeof(ProbedFragment));
    std::ranges::sort(fragments, {}, [](const ProbedFragment& f) { return std::tuple(f.depth, f.card); });
    return fragments;
  }
}

std::optional<float> opaque_depth_at(gpu::Device& device, gpu::Pipelines& pipelines, const Targets& targets,
                                     const Transparents& transparents, glm::uvec2 pixel) {
  const gpu::Image& depth = targets.opaque_depth;
  const gpu::Buffer texel(
      device, {.owner = "probe", .label = "opaque depth", .bytes = sizeof(float), .host_visible = true});
  gpu::Frame frame(device, pipelines);
  frame.pass("opaque depth", [&](gpu::Pass& pass) {
    pass.commands().copyImageToBuffer(
        depth.vk(), vk::ImageLayout::eGeneral, texel.vk(),
        vk::BufferImageCopy{.imageSubresource = {.aspectMask = depth.aspect(), .layerCount = 1},
                            .imageOffset = {int32_t(pixel.x), int32_t(pixel.y), 0},
                            .imageExtent = {1, 1, 1}});
  });
  frame.finish();
  const float reversed = texel.mapped<float>()[0];
  if (reversed <= 0.0f) return std::nullopt;
  return gpu::read<shared::ViewData>(device, *transparents.view)[0].near_m / reversed;
}

std::vector<glm::vec3> transmittance_at(gpu::Device& device, gpu::Pipelines& pipelines,
                                        const Targets& targets, const Transparents& transparents,
                                        const MethodInstance& instance, const Probe& probe) {
  gpu::Frame frame(device, pipelines);
  instance.method->probe({.frame = frame,
                          .resources = instance.resources,
                          .transparents = transparents,
                          .opaque_color = targets.opaque_color,
                          .opaque_depth = targets.opaque_depth,
                          .result = targets.result,
                          .size = targets.size},
                         probe);
  frame.finish();
  return probe.read_answer(device);
}

}  // namespace plume
