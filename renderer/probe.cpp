#include "renderer/probe.h"

#include <bit>

namespace plume {
namespace {

std::vector<shared::ProbedPoint> lights_at(const std::vector<float>& depths) {
  std::vector<shared::ProbedPoint> points;
  for (const float depth : depths)
    points.push_back({.depth = depth, .card = shared::kBareLight, .transmittance = glm::vec3(1.0f)});
  return points;
}

}  // namespace

Probe::Probe(gpu::Device& device, glm::uvec2 at, std::span<const shared::ProbedPoint> asked)
    : pixel(at), points(asked.begin(), asked.end()) {
  const shared::ProbeQuery head{.pixel = pixel, .count = uint32_t(points.size()), .padding = 0};
  std::vector<std::byte> bytes(sizeof(head) + points.size() * sizeof(points[0]));
  std::memcpy(bytes.data(), &head, sizeof(head));
  if (!points.empty())
    std::memcpy(bytes.data() + sizeof(head), points.data(), points.size() * sizeof(points[0]));
  query = gpu::make_buffer(device, "probe", "query", bytes);
  answer = gpu::Buffer(device, {.owner = "probe",
                                .label = "answer",
                                .bytes = std::max<uint64_t>(points.size(), 1) * sizeof(glm::vec3)});
}

Probe::Probe(gpu::Device& device, glm::uvec2 at, const std::vector<float>& depths)
    : Probe(device, at, lights_at(depths)) {}

std::vector<glm::vec3> Probe::read_answer(gpu::Device& device) const {
  auto values = gpu::read<glm::vec3>(device, answer);
  values.resize(points.size());
  return values;
}

void probe_with(const Picture& picture, const Probe& probe, const std::string& shader,
                const gpu::Constants& constants, gpu::Bindings bindings) {
  bindings.push_back({"View", picture.transparents.view});
  bindings.push_back({"Cards", picture.transparents.cards});
  bindings.push_back({"ProbePoints", &probe.query});
  bindings.push_back({"ProbeAnswer", &probe.answer});
  const auto count = uint32_t(probe.points.size());
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
                               .pixel = probe.pixel,
                               .constants = {in_front == InFront::kByCenter ? 1u : 0u},
                               .bindings = {{"ProbePoints", &probe.query}, {"ProbeAnswer", &probe.answer}}});
  });
}

}  // namespace plume
