#include "renderer/methods/avboit/plan.h"

#include <cmath>

namespace plume::avboit {

Plan::Plan(const Settings& chosen, glm::uvec2 picture_size, const Transparents& transparents)
    : settings(chosen),
      size(picture_size),
      rgb(chosen.colour == Colour::kRgb && transparents.number(Source::kRgb) > 0),
      coloured(chosen.colour != Colour::kMono && transparents.number(Source::kRgb) > 0),
      first_coloured(coloured ? transparents.first(Source::kRgb) : transparents.count) {
  const bool self_excluded = settings.sampling == Sampling::kSelfExcluded;
  const bool spline = settings.sampling == Sampling::kQuadratic || settings.sampling == Sampling::kCubic;
  const uint32_t bias = self_excluded ? 0 : uint32_t(std::ceil(settings.bias));
  const uint32_t divisor = settings.divisor();
  const glm::uvec2 cells = (size + divisor - 1u) / divisor;
  volume = {.cells = cells,
            .tiles = (cells + shared::kTileCells - 1u) / shared::kTileCells,
            .divisor = divisor,
            .slices = settings.slice_count(),
            .virtual_slices = settings.virtual_slice_count(),
            .fixed_slices = settings.adaptive ? 0u : 1u,
            .curve_a = settings.curve_a,
            .curve_octaves = std::log2(1.0f + settings.curve_b / settings.curve_a),
            .bias = self_excluded ? 0.0f : settings.bias,
            .guard_before = bias + (spline ? 1 : 0),
            .guard_after = spline && settings.bias < 1.0f ? 2u : 1u,
            .zero_depth = -std::log(settings.zero_transmittance),
            .zero_guard = std::max(bias, 1u) + (spline ? 1 : 0),
            .rgb_first = rgb ? transparents.first(Source::kRgb) : transparents.count,
            .cards = transparents.count,
            .exact_layers = settings.exact_layer_count(),
            .small_cells = settings.small_cells};
}

}  // namespace plume::avboit
