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

/// `is_wrong(pixel, channel)` says what would be right, or "". Methods that are exact but round otherwise
/// than a draw does may see an edge on the other side of a pixel's centre.
template <class IsWrong>
std::optional<std::string> PictureBounds::pixels_that(const IsWrong& is_wrong, const Image& picture,
                                                      const Traits& traits) const {
  const size_t at_edges = traits.exact && traits.rounding > 0 ? 1 + pixels_.size() / 100 : 0;
  size_t wrong = 0;
  std::string first;
  for (size_t i = 0; i < pixels_.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const std::string right = is_wrong(i, c);
      if (right.empty()) continue;
      if (wrong++ == 0)
        first = fmt::format("pixel {},{} channel {}: {} is not {}, {} fragments", i % size_t(picture.width),
                            i / size_t(picture.width), c, picture.pixels[i][c], right, pixels_[i].fragments);
      break;
    }
  if (wrong <= at_edges) return {};
  return fmt::format("{}; {} of {} pixels", first, wrong, pixels_.size());
}

std::optional<std::string> PictureBounds::breach(const Image& picture, const Traits& traits,
                                                 bool fell_short) const {
  const auto is_wrong = [&](size_t i, int c) -> std::string {
    const Pixel& pixel = pixels_[i];
    const bool is_untouched = pixel.fragments == 0 && !traits.moves_background;
    const double roundings = is_untouched ? 0.0 : double(pixel.fragments + 3),
                 slack = roundings * std::max(kHalfRounding, traits.rounding), room = roundings * kLeastHalf;
    const glm::dvec3 here(background_.pixels[i]);
    const double value = double(picture.pixels[i][c]),
                 least = pixel.through_least * (traits.moves_background ? darkest_ : here)[c],
                 most =
                     pixel.through_most * (traits.moves_background ? brightest_ : here)[c] + pixel.light[c];
    const bool has_no_most = fell_short || most * (1 + slack) >= kLargestHalf;
    // Written so that NaN fails too.
    const bool is_within = value >= 0 && value >= least * (1 - slack) - room &&
                           (has_no_most || value <= most * (1 + slack) + room);
    return is_within ? "" : fmt::format("from {} to {}", least, most);
  };
  return pixels_that(is_wrong, picture, traits);
}

std::optional<std::string> PictureBounds::difference(const Image& exact, const Image& picture,
                                                     const Traits& traits) const {
  float brightest = 0.0f;
  for (const glm::vec3& pixel : exact.pixels) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
  const auto is_wrong = [&](size_t i, int c) -> std::string {
    if (traits.rounding > 0 && !pixels_[i].is_ordered) return "";
    const double right = double(exact.pixels[i][c]), value = double(picture.pixels[i][c]),
                 allowed = (1e-3 + double(pixels_[i].fragments) * traits.rounding) * double(brightest);
    // Written so that NaN fails too; two infinities are equal.
    const bool is_right = value == right || std::abs(value - right) <= allowed;
    return is_right ? "" : fmt::format("{} give or take {}", right, allowed);
  };
  return pixels_that(is_wrong, picture, traits);
}

size_t PictureBounds::deepest() const {
  return std::ranges::max_element(pixels_, {}, &Pixel::fragments)->fragments;
}

}  // namespace plume
