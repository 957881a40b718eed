#include "sandbox/measure/pixel_probe.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace plume {
namespace {

/// Evenly in ratio.
std::vector<float> depths_of(const ProbedDepths& asked, const std::vector<PixelFragment>& fragments) {
  const auto [nearest, farthest] = asked.range_m.value_or(
      fragments.empty() ? std::pair(1.0f, 100.0f)
                        : std::pair(fragments.front().depth_m * 0.9f, fragments.back().depth_m * 1.1f));
  std::vector<float> depths;
  for (uint32_t i = 0; i < asked.count; ++i)
    depths.push_back(nearest * std::pow(farthest / nearest, float(i) / float(std::max(asked.count, 2u) - 1)));
  return depths;
}

std::vector<PixelFragment> told_apart(const Stage& stage,
                                      const std::vector<shared::ProbedFragment>& fragments) {
  std::vector<PixelFragment> result;
  glm::dvec3 through(1.0);
  for (const shared::ProbedFragment& f : fragments) {
    result.push_back({.depth_m = f.depth,
                      .card = f.card,
                      .owner = owner_of(stage, f.card),
                      .light = f.color + f.emission,
                      .color = f.coverage > 0.0f ? f.color / f.coverage : glm::vec3(0.0f),
                      .emission = f.emission,
                      .alpha = f.coverage,
                      .transmittance = f.transmittance,
                      .weight = glm::vec3(through)});
    through *= glm::dvec3(f.transmittance);
  }
  return result;
}

}  // namespace

glm::dvec3 PixelProbe::exact_transmittance(double depth_m) const {
  glm::dvec3 through(1.0);
  for (const PixelFragment& f : fragments)
    if (double(f.depth_m) < depth_m) through *= glm::dvec3(f.transmittance);
  return through;
}

PixelProbe probe_pixel(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                       const Targets& targets, glm::uvec2 pixel, const ProbedDepths& depths) {
  const Transparents& transparents = stage.transparents();
  PixelProbe probe{
      .scene = stage.scene().id,
      .tick = stage.simulation().tick(),
      .size = targets.size,
      .pixel = pixel,
      .opaque_m = opaque_depth_at(device, pipelines, targets, transparents, pixel),
      .fragments = told_apart(stage, fragments_at(device, pipelines, targets, transparents, pixel)),
      .depths_m = {}};
  probe.depths_m = depths_of(depths, probe.fragments);
  return probe;
}

MethodAtPixel unavailable_at_pixel(gpu::Device& device, const MethodInstance& instance) {
  const auto missing = instance.method->missing(device);
  return {.id = std::string(instance.method->id()),
          .name = instance.owner,
          .settings = parameter_values(*instance.method),
          .status =
              missing.empty() ? "not drawn" : fmt::format("unavailable: needs {}", fmt::join(missing, ", "))};
}

MethodAtPixel probe_method(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                           const Targets& targets, const MethodInstance& instance, const PixelProbe& at) {
  std::vector<shared::ProbedPoint> points;
  for (const float depth : at.depths_m)
    points.push_back({.depth = depth, .card = shared::kBareLight, .transmittance = glm::vec3(1.0f)});
  for (const PixelFragment& f : at.fragments)
    points.push_back({.depth = f.depth_m,
                      .card = f.card,
                      .transmittance = f.transmittance,
                      .color = f.color * f.alpha,
                      .coverage = f.alpha,
                      .emission = f.emission});
  const Probe probe(device, at.pixel, std::span<const shared::ProbedPoint>(points));
  const auto told = transmittance_at(device, pipelines, targets, stage.transparents(), instance, probe);
  const auto first_fragment = told.begin() + ptrdiff_t(at.depths_m.size());
  return {.id = std::string(instance.method->id()),
          .name = instance.owner,
          .settings = parameter_values(*instance.method),
          .transmittance = {told.begin(), first_fragment},
          .weights = {first_fragment, told.end()},
          .marks = instance.method->depth_marks(device, instance.resources, stage.transparents(), at.pixel)};
}

}  // namespace plume
