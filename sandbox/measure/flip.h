// LDR-FLIP: how large the difference looks to someone who flips between two pictures on a display.
//
// Andersson, Nilsson, Akenine-Moeller, Oskarsson, Astroem, Fairchild, "FLIP: A Difference Evaluator for
// Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), article 15 (HPG 2020).
#ifndef PLUME_MEASURE_FLIP_H
#define PLUME_MEASURE_FLIP_H

#include "sandbox/measure/image.h"

namespace plume {

/// A 0.7 m wide display of 3840 pixels seen from 0.7 m, the paper's default. Rounded from 67.02.
inline constexpr double kFlipPixelsPerDegree = 67.0;

struct FlipResult {
  Raster<float> map;  ///< error of each pixel: 0 cannot be told apart, 1 is the largest there can be
  double mean = 0.0;  ///< over the map
};

/// Symmetric in its two pictures; identical ones give exactly 0. Black against white gives 0.9674 and not 1:
/// the scale ends at green against blue, the display colours farthest apart. Computed in float, each error
/// within 1e-4 of the exact one. Pictures are continued outwards by their border pixels. Throws
/// std::invalid_argument when the sizes differ, a picture is empty, or `pixels_per_degree` is not in 1..1000.
FlipResult flip(const DisplayImage& reference, const DisplayImage& test,
                double pixels_per_degree = kFlipPixelsPerDegree);

}  // namespace plume
#endif
