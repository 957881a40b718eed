#include "sandbox/measure/value_map.h"

#include <algorithm>
#include <cmath>

#include "sandbox/measure/magma.h"

namespace plume {
namespace {

constexpr int kStripePixels = 4;
constexpr std::array<uint8_t, 3> kStripes[] = {{38, 42, 44}, {56, 62, 64}};
constexpr float kLogSpan = 1e4f;  // of a logarithmic scale that has nothing to begin at

// Okabe and Ito's, which people who see few colours tell apart; each with its shade for the pattern.
struct ClassLook {
  std::array<uint8_t, 3> color, shade;
};
constexpr ClassLook kClasses[] = {{{86, 180, 233}, {86, 180, 233}},
                                  {{230, 159, 0}, {120, 80, 0}},
                                  {{240, 228, 66}, {70, 66, 10}},
                                  {{204, 121, 167}, {80, 36, 60}}};

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

ValueRange joined(const ValueRange& a, const ValueRange& b) {
  if (a.count == 0 || b.count == 0) return a.count == 0 ? b : a;
  const bool both = a.least_positive > 0 && b.least_positive > 0;
  return {.least = std::min(a.least, b.least),
          .most = std::max(a.most, b.most),
          .least_positive = both ? std::min(a.least_positive, b.least_positive)
                                 : std::max(a.least_positive, b.least_positive),
          .sum = a.sum + b.sum,
          .count = a.count + b.count};
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
      image.pixels.push_back(std::isnan(value) ? absent_texel(x, y) : magma(scale.share_of(value)));
    }
  return image;
}

std::array<uint8_t, 3> absent_texel(int x, int y) {
  return kStripes[(x + y) / kStripePixels % 2];
}

/// Plain, lying lines, a chequerboard, standing lines.
std::array<uint8_t, 3> class_texel(size_t index, int x, int y) {
  const ClassLook& look = kClasses[index % std::size(kClasses)];
  const bool shaded[] = {false, y / 2 % 3 == 0, (x / 3 + y / 3) % 2 == 0, x / 2 % 3 == 0};
  return shaded[index % std::size(kClasses)] ? look.shade : look.color;
}

DisplayImage class_image(const Raster<float>& values) {
  DisplayImage image{values.width, values.height, {}};
  image.pixels.reserve(values.pixels.size());
  for (int y = 0; y < values.height; ++y)
    for (int x = 0; x < values.width; ++x) {
      const float value = values.pixels[size_t(y) * size_t(values.width) + size_t(x)];
      image.pixels.push_back(value >= 1.0f ? class_texel(size_t(value) - 1, x, y) : absent_texel(x, y));
    }
  return image;
}

}  // namespace plume
