// The transmittance over depth that a method gave marked pixels of a measured frame, and the exact one: what
// results.json keeps of them under `probes`, by the code of `plume probe`.
//
//   {"pixel": [x, y], "depth_m": [...], "exact": [...], "transmittance": [...], "opaque_depth_m": …, or null
//    for the sky, "zero_depth_m": … or null: behind it the method draws nothing}
//
// Transmittances are luminances (Rec. 709), or all of them [r, g, b] where either curve is coloured. Numbers
// have six digits.
#ifndef PLUME_RUNS_FRAME_PROBE_H
#define PLUME_RUNS_FRAME_PROBE_H

#include "sandbox/measure/pixel_probe.h"

namespace plume {

/// Points of a curve at most: 64 evenly in ratio, and both sides of each step.
constexpr size_t kCurvePoints = 256, kEvenCurvePoints = 64;

/// Where a curve is asked for: before and behind each fragment, so that steps stay steps, and in between.
/// Where there are more fragments than points, those that take the least light go without.
std::vector<float> curve_depths(const PixelProbe& probe);

/// The exact side of the picture that was drawn last into `targets`, with the depths of the curves.
std::vector<PixelProbe> probe_marked(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                                     const Targets& targets, std::span<const glm::uvec2> pixels);

nlohmann::json frame_probe(const PixelProbe& exact, const MethodAtPixel& method);
/// Of the method that drew that picture.
nlohmann::json frame_probes(gpu::Device& device, gpu::Pipelines& pipelines, const Stage& stage,
                            const Targets& targets, const MethodInstance& instance,
                            std::span<const PixelProbe> marked);

}  // namespace plume
#endif
