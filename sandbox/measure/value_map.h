// Numbers of pixels as a picture: magma colours on a scale, a colour and a pattern for each class, and
// stripes where there is no number.
#ifndef PLUME_MEASURE_VALUE_MAP_H
#define PLUME_MEASURE_VALUE_MAP_H

#include <array>
#include <optional>

#include "sandbox/measure/image.h"

namespace plume {

/// From numbers to shares of a colour bar. `low` < `high`; above 0 both where it is logarithmic.
struct ValueScale {
  float low = 0.0f, high = 1.0f;
  bool logarithmic = false;

  /// 0..1; what lies beyond an end is at the end.
  float share_of(float value) const;
  /// The number that stands at a share of the bar.
  float value_at(float share) const;
};

/// What is among the numbers that are finite.
struct ValueRange {
  float least = 0.0f, most = 0.0f, least_positive = 0.0f;
  double sum = 0.0;
  size_t count = 0;  ///< of pixels that have one
};
ValueRange range_of(const Raster<float>& values);
/// Of two pictures as if they were one.
ValueRange joined(const ValueRange& a, const ValueRange& b);

/// Over `wanted` (nothing: from the least number to the most), which is made fit for the scale: a logarithmic
/// one begins at the least number above 0, and no scale is empty.
ValueScale scale_over(const ValueRange& found, const std::optional<glm::vec2>& wanted, bool logarithmic);

/// Infinities are at the end of the scale; pixels without a number are striped in two greys, so that they
/// cannot be taken for either end.
DisplayImage value_image(const Raster<float>& values, const ValueScale& scale);

/// The same of numbers 1, 2, ... that are classes: each has a colour, and a pattern that tells it without.
DisplayImage class_image(const Raster<float>& values);
/// What these pictures have at a pixel, for keys to them: of the class `index` (from 0), and of no number.
std::array<uint8_t, 3> class_texel(size_t index, int x, int y);
std::array<uint8_t, 3> absent_texel(int x, int y);

}  // namespace plume
#endif
