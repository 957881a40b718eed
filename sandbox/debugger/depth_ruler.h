// What a camera offset does: the particles of an instance's emitters over depth, where they are (outline) and
// where they are drawn (filled), and below them the slices that the method has: physical ones as boxes with
// empty space between them, virtual ones as ticks.
#ifndef PLUME_DEBUGGER_DEPTH_RULER_H
#define PLUME_DEBUGGER_DEPTH_RULER_H

#include <array>
#include <span>

#include "sandbox/workspace/emitter_depths.h"

namespace plume {

/// How particles are spread over the logarithm of depth. There may be hundreds of thousands, so this is made
/// once a picture, not once a frame.
struct DepthBins {
  static constexpr size_t kBins = 48;
  using Bins = std::array<float, kBins>;  ///< the fullest has 1
  struct Row {
    Bins is, drawn;  ///< without and with the offset
  };
  float nearest_m = 0, farthest_m = 0;  ///< of the first and the last bin; 0: there are no particles
  std::vector<Row> rows;                ///< one an emitter
};
DepthBins depth_bins(std::span<const EmitterDepths> emitters, float near_m);

void depth_ruler(std::span<const EmitterDepths> emitters, const DepthBins& bins, std::optional<size_t> chosen,
                 float near_m, const SlicedDepth& slices);

}  // namespace plume
#endif
