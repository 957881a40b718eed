#include "tests/property/picture_bounds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tests/gpu/fragment_lists.h"

namespace plume {
namespace {

constexpr double kHalfRounding = 1.0 / 2048;
constexpr double kLeastHalf = 6e-8;        // what is smaller is none
constexpr double kLargestHalf = 65504;     // above that there is only infinity
constexpr double kLeastCover = 1.0 / 255;  // methods that average take what covers less for a light
constexpr float kDepthRounding = 4e-6f;    // of an interpolated depth, relative
/// Averages divide two half floats, which may both be as small as half floats get.
constexpr double kAverageSlack = 2.0;

}  // namespace

PictureBounds::PictureBounds(gpu::Device& device, const Resources& resources, Image background)
    : background_(std::move(background)), darkest_(background_.pixels.at(0)), brightest_(darkest_) {
  const FragmentLists lists(device, resources);
  fragments_ = lists.count;
  for (size_t i = 0; i < background_.pixels.size(); ++i) {
    Pixel& pixel = pixels_.emplace_back();
    glm::dvec3 brightest(0.0);
    float depth = 0.0f;
    for (const shared::FragmentNode& f : lists.of(i)) {  // nearest first
      if (pixel.fragments > 0 && f.depth - depth <= kDepthRounding * depth) pixel.is_ordered = false;
      depth = f.depth;
      const auto [least, most] =
          std::minmax({double(f.transmittance.r), double(f.transmittance.g), double(f.transmittance.b)});
      ++pixel.fragments;
      pixel.through_least *= least;
      pixel.through_most *= most;
      pixel.light += glm::dvec3(f.light);
      brightest = glm::max(brightest, glm::dvec3(f.light) / std::max(1 - most, kLeastCover));
    }
    pixel.light += kAverageSlack * brightest;
    darkest_ = glm::min(darkest_, glm::dvec3(background_.pixels[i]));
    brightest_ = glm::max(brightest_, glm::dvec3(background_.pixels[i]));
  }
}

std::optional<std::string> PictureBounds::breach(const Image& picture, const Traits& traits) const {
  size_t breaches = 0;
  std::string first;
  for (size_t i = 0; i < pixels_.size(); ++i) {
    const Pixel& pixel = pixels_[i];
    const bool untouched = pixel.fragments == 0 && !traits.moves_background;
    const double slack =
        untouched ? 0.0 : double(pixel.fragments + 3) * std::max(kHalfRounding, traits.rounding);
    const glm::dvec3 here(background_.pixels[i]);
    for (int c = 0; c < 3; ++c) {
      const double least = pixel.through_least * (traits.moves_background ? darkest_ : here)[c],
                   most =
                       pixel.through_most * (traits.moves_background ? brightest_ : here)[c] + pixel.light[c],
                   value = double(picture.pixels[i][c]),
                   room = untouched ? 0.0 : double(pixel.fragments + 3) * kLeastHalf;
      const bool is_too_bright_for_halves = most * (1 + slack) >= kLargestHalf && value > 0;
      // Written so that NaN fails too.
      if (value >= 0 && value >= least * (1 - slack) - room &&
          (value <= most * (1 + slack) + room || is_too_bright_for_halves))
        continue;
      if (breaches++ == 0)
        first = fmt::format("pixel {},{} channel {}: {} is not from {} to {}, {} fragments",
                            i % size_t(picture.width), i / size_t(picture.width), c, value, least, most,
                            pixel.fragments);
      break;
    }
  }
  if (breaches == 0) return {};
  return fmt::format("{}; {} of {} pixels", first, breaches, pixels_.size());
}

std::optional<std::string> PictureBounds::difference(const Image& exact, const Image& picture,
                                                     const Traits& traits) const {
  float brightest = 0.0f;
  for (const glm::vec3& pixel : exact.pixels) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
  const double allowed = (1e-3 + traits.rounding) * double(brightest);
  for (size_t i = 0; i < pixels_.size(); ++i) {
    if (traits.rounding > 0 && !pixels_[i].is_ordered) continue;
    for (int c = 0; c < 3; ++c)
      // Written so that NaN fails too; two infinities are equal.
      if (const float a = exact.pixels[i][c], b = picture.pixels[i][c];
          a != b && !(std::abs(double(a) - double(b)) <= allowed))
        return fmt::format("pixel {},{} channel {}: {} instead of {}, which may be off by {}, {} fragments",
                           i % size_t(picture.width), i / size_t(picture.width), c, b, a, allowed,
                           pixels_[i].fragments);
  }
  return {};
}

size_t PictureBounds::deepest() const {
  return std::ranges::max_element(pixels_, {}, &Pixel::fragments)->fragments;
}

}  // namespace plume
