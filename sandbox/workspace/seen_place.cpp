#include "sandbox/workspace/seen_place.h"

#include <algorithm>

namespace plume {
namespace {

double mean(glm::dvec3 color) {
  return (color.r + color.g + color.b) / 3;
}

}  // namespace

std::optional<SeenDepth> seen_depth(const PixelProbe& probe) {
  std::vector<double> shares;
  double sum = 0, through = 1;
  for (const PixelFragment& f : probe.fragments) {
    const double kept = 1 - mean(f.transmittance), glow = std::min(mean(f.emission), 1.0);
    shares.push_back(mean(f.weight) * std::max(kept, glow));
    sum += shares.back();
    through = mean(glm::dvec3(f.weight) * glm::dvec3(f.transmittance));
  }
  const double half = 0.5 * (sum + (probe.opaque_m ? through : 0.0));
  double before = 0;
  for (size_t i = 0; i < shares.size(); ++i)
    if ((before += shares[i]) >= half && before > 0)
      return SeenDepth{.depth_m = probe.fragments[i].depth_m, .fragment = i};
  if (!probe.opaque_m) return {};
  return SeenDepth{.depth_m = *probe.opaque_m, .fragment = {}};
}

std::optional<SeenPlace> seen_at(Workspace& workspace, glm::vec2 place) {
  if (!workspace.shown()) return {};
  const Targets& targets = *workspace.shown();
  const glm::vec2 size(targets.size);
  const glm::uvec2 pixel(glm::clamp(place * size, glm::vec2(0), size - 1.0f));
  const PixelProbe probe =
      probe_pixel(workspace.device(), workspace.pipelines(), workspace.stage(), targets, pixel, {.count = 1});
  const auto depth = seen_depth(probe);
  if (!depth) return {};
  return SeenPlace{
      .position = point_at(workspace.drawn_view(), (glm::vec2(pixel) + 0.5f) / size, depth->depth_m),
      .instance = depth->fragment ? probe.fragments[*depth->fragment].owner.instance : ""};
}

}  // namespace plume
