#include "sandbox/measure/value_map.h"

#include <algorithm>
#include <cmath>

#include "sandbox/measure/magma.h"

namespace plume {
namespace {

constexpr int kStripePixels = 4;
constexpr std::array<uint8_t, 3> kStripes[] = {{38, 42, 44}, {56, 62, 64}};
constexpr float kLogSpan = 1e4f;  // of a logarithmic scale that has nothing to begin at

}  // namespace

float ValueScale::share_of(float value) const {
  const float share = logarithmic ? std::log(std::max(value, low) / low) / std::log(high / low)
                                  : (value - low) / (high - low);
  return std::clamp(share, 0.0f, 1.0f);
}

float ValueScale::value_at(float share) const {
  return logarithmic ? low * std::pow(high / low, share) : low + share * (high - low);
}

ValueRange range_of(const Raster<float>& values) {
  ValueRange range;
  for (const float value : values.pixels) {
    if (!std::isfinite(value)) continue;
    if (range.count++ == 0) range.least = range.most = value;
    range.least = std::min(range.least, value);
    range.most = std::max(range.most, value);
    if (value > 0 && (range.least_positive == 0 || value < range.least_positive))
      range.least_positive = value;
    range.sum += double(value);
  }
  return range;
}

ValueScale scale_over(const ValueRange& found, const std::optional<glm::vec2>& wanted, bool logarithmic) {
  ValueScale scale{.low = wanted ? wanted->x : found.least,
                   .high = wanted ? wanted->y : found.most,
                   .logarithmic = logarithmic};
  if (!logarithmic) {
    if (!(scale.high > scale.low)) scale.high = scale.low + 1.0f;
    return scale;
  }
  if (!(scale.high > 0.0f)) scale.high = 1.0f;
  if (!(scale.low > 0.0f))
    scale.low = found.least_positive > 0.0f ? found.least_positive : scale.high / kLogSpan;
  if (!(scale.high > scale.low)) scale.high = 2.0f * scale.low;
  return scale;
}

DisplayImage value_image(const Raster<float>& values, const ValueScale& scale) {
  DisplayImage image{values.width, values.height, {}};
  image.pixels.reserve(values.pixels.size());
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x) {
      const float value = values.pixels[size_t(y) * size_t(values.width) + size_t(x)];
      image.pixels.push_back(std::isnan(value) ? kStripes[(x + y) / kStripePixels % 2]
                                               : magma(scale.share_of(value)));
    }
  return image;
}

}  // namespace plume
