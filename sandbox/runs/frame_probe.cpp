#include "sandbox/runs/frame_probe.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace plume {
namespace {

using nlohmann::json;

double rounded(double value) {
  return std::stod(fmt::format("{:.6g}", value));
}

json or_null(const std::optional<float>& depth_m) {
  return depth_m ? json(rounded(*depth_m)) : json(nullptr);
}

float brightest(glm::vec3 c) {
  return std::max({c.r, c.g, c.b});
}

/// Light that it keeps from what is behind it.
float taken_by(const PixelFragment& f) {
  return brightest(f.weight * (glm::vec3(1.0f) - f.transmittance));
}

bool is_coloured(const std::vector<glm::vec3>& curve) {
  return std::ranges::any_of(curve, [](glm::vec3 c) {
    return brightest(c) - std::min({c.r, c.g, c.b}) > 1e-4f;
  });
}

json curve_json(const std::vector<glm::vec3>& curve, bool coloured) {
  json list = json::array();
  for (const glm::vec3& c : curve)
    if (coloured)
      list.push_back({rounded(c.r), rounded(c.g), rounded(c.b)});
    else
      list.push_back(rounded(glm::dot(glm::dvec3(c), glm::dvec3(0.2126, 0.7152, 0.0722))));
  return list;
}

}  // namespace

std::vector<float> curve_depths(const PixelProbe& probe) {
  std::vector<const PixelFragment*> steps;
  for (const PixelFragment& f : probe.fragments) steps.push_back(&f);
  constexpr size_t kSteps = (kCurvePoints - kEvenCurvePoints) / 2;
  if (steps.size() > kSteps) {
    std::ranges::stable_sort(steps, std::greater(), [](const PixelFragment* f) { return taken_by(*f); });
    steps.resize(kSteps);
  }
  std::vector<float> depths = probe.depths_m;
  for (const PixelFragment* f : steps)
    for (const float depth : {f->depth_m, std::nextafter(f->depth_m, std::numeric_limits<float>::max())})
      depths.push_back(depth);
  std::ranges::sort(depths);
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  return depths;
}

std::vector<PixelProbe> probe_marked(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                                     const Targets& targets, std::span<const glm::uvec2> pixels) {
  std::vector<PixelProbe> marked;
  for (const glm::uvec2& pixel : pixels) {
    marked.push_back(
        probe_pixel(device, pipelines, stage, targets, pixel, {.count = uint32_t(kEvenCurvePoints)}));
    marked.back().depths_m = curve_depths(marked.back());
  }
  return marked;
}

json frame_probe(const PixelProbe& exact, const MethodAtPixel& method) {
  std::vector<glm::vec3> steps;
  json depths = json::array();
  for (const float depth : exact.depths_m) {
    steps.emplace_back(exact.exact_transmittance(double(depth)));
    depths.push_back(rounded(depth));
  }
  const bool coloured = is_coloured(steps) || is_coloured(method.transmittance);
  return {{"pixel", {exact.pixel.x, exact.pixel.y}},
          {"depth_m", std::move(depths)},
          {"exact", curve_json(steps, coloured)},
          {"transmittance", curve_json(method.transmittance, coloured)},
          {"opaque_depth_m", or_null(exact.opaque_m)},
          {"zero_depth_m", or_null(method.marks.zero_m)}};
}

json frame_probes(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage, const Targets& targets,
                  const MethodInstance& instance, std::span<const PixelProbe> marked) {
  json probes = json::array();
  for (const PixelProbe& exact : marked)
    probes.push_back(frame_probe(exact, probe_method(device, pipelines, stage, targets, instance, exact)));
  return probes;
}

}  // namespace plume
