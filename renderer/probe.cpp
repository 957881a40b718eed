#include "renderer/probe.h"

#include <bit>

#include "shaders/probe/probe.h"

namespace plume {

Probe::Probe(gpu::Device& device, glm::uvec2 at, std::vector<float> at_depths)
    : pixel(at), depths(std::move(at_depths)) {
  const shared::ProbeQuery head{.pixel = pixel, .count = uint32_t(depths.size()), .padding = 0};
  std::vector<std::byte> bytes(sizeof(head) + depths.size() * sizeof(float));
  std::memcpy(bytes.data(), &head, sizeof(head));
  std::memcpy(bytes.data() + sizeof(head), depths.data(), depths.size() * sizeof(float));
  query = gpu::make_buffer(device, "probe", "query", bytes);
  answer = gpu::Buffer(device, {.owner = "probe",
                                .label = "answer",
                                .bytes = std::max<uint64_t>(depths.size(), 1) * sizeof(glm::vec3)});
}

std::vector<glm::vec3> Probe::read_answer(gpu::Device& device) const {
  auto values = gpu::read<glm::vec3>(device, answer);
  values.resize(depths.size());
  return values;
}

void probe_with(const Picture& picture, const Probe& probe, const std::string& shader,
                const gpu::Constants& constants, gpu::Bindings bindings) {
  bindings.push_back({"View", picture.transparents.view});
  bindings.push_back({"Cards", picture.transparents.cards});
  bindings.push_back({"ProbeDepths", &probe.query});
  bindings.push_back({"ProbeAnswer", &probe.answer});
  const auto count = uint32_t(probe.depths.size());
  picture.frame.pass("probe", [&](gpu::Pass& pass) {
    pass.dispatch(pass.pipelines().compute(shader, constants), bindings, count,
                  {gpu::groups(count, 64), 1, 1});
  });
}

void probe_by_drawing(const Picture& picture, const Probe& probe, InFront in_front) {
  picture.frame.pass("probe", [&](gpu::Pass& pass) {
    pass.fill(probe.answer, std::bit_cast<uint32_t>(1.0f));
    pass.barrier();
    picture.transparents.draw(pass,
                              {.fragment = "probe/in_front.frag",
                               .targets = {},
                               .depth_test = &picture.opaque_depth,
                               .opaque_depth = &picture.opaque_depth,
                               .area = picture.area(),
                               .constants = {in_front == InFront::kByCenter ? 1u : 0u},
                               .bindings = {{"ProbeDepths", &probe.query}, {"ProbeAnswer", &probe.answer}}});
  });
}

}  // namespace plume
