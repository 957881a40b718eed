// What a requested slice thickness means: the virtual resolution that AVBOIT starts from.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "renderer/methods/avboit/settings.h"
#include "shaders/methods/avboit/volume.h"

namespace plume::avboit {
namespace {

/// Depth at which virtual slice `s` of `n` begins.
double depth_of(double s, double n, const Settings& settings) {
  const double a = settings.curve_a, b = settings.curve_b;
  return a * (std::pow(1 + b / a, s / n) - 1);
}

/// The thickest slice that begins before the end of the range.
double thickest(double n, const Settings& settings) {
  double most = 0;
  for (double s = 0; s < n && depth_of(s, n, settings) < double(settings.thickness_range); ++s)
    most = std::max(most, std::min(depth_of(s + 1, n, settings), double(settings.thickness_range)) -
                              depth_of(s, n, settings));
  return most;
}

TEST(AvboitSettings, SlicesAreAsThinAsAskedForUpToTheRange) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> octave(0.0f, 1.0f);
  size_t met = 0;
  for (int i = 0; i < 200; ++i) {
    Settings s;
    s.curve_a = std::exp2(octave(random) * 6 - 2);
    s.curve_b = s.curve_a * std::exp2(3 + octave(random) * 8);
    s.thickness_range = s.curve_b * octave(random);
    s.slice_thickness = std::exp2(-octave(random) * 7);
    const uint32_t n = s.virtual_slice_count();
    EXPECT_EQ(0u, n & (n - 1)) << "a power of two";
    if (n == shared::kMostVirtualSlices && thickest(n, s) > double(s.slice_thickness)) continue;
    ++met;
    EXPECT_LE(thickest(n, s), double(s.slice_thickness) * 1.000001);
    // No more than needed: a slice of half as many that begins at the end of the range is too thick.
    if (n > shared::kMostSlices) {
      const double per_metre = (double(s.curve_a) + s.thickness_range) *
                               std::log1p(double(s.curve_b) / double(s.curve_a)) / (n / 2);
      EXPECT_GT(per_metre, double(s.slice_thickness) * 0.999999);
    }
  }
  EXPECT_GT(met, 100u);
}

TEST(AvboitSettings, WithoutARequestTheChosenVirtualResolutionHolds) {
  Settings s;
  for (s.virtual_slices = 0; s.virtual_slices < 6; ++s.virtual_slices)
    EXPECT_EQ(1024u << s.virtual_slices, s.virtual_slice_count());
}

}  // namespace
}  // namespace plume::avboit
