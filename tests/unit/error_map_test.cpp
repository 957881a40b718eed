#include "sandbox/measure/error_map.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plume {
namespace {

using Rgb = std::array<uint8_t, 3>;

Rgb colour_of(float error) {
  return magma_image({1, 1, {error}}).pixels[0];
}

TEST(ErrorMapTest, ScaleRunsFromMagmasFirstColourToItsLast) {
  EXPECT_EQ(colour_of(0.0f), (Rgb{0, 0, 4}));
  EXPECT_EQ(colour_of(1.0f), (Rgb{252, 253, 191}));
}

TEST(ErrorMapTest, ColoursBetweenTheKnotsAreNearTheFullTable) {
  // Entries 100, 128 and 200 of matplotlib's table, none of them a knot.
  const struct {
    int entry;
    Rgb rgb;
  } cases[] = {{100, {137, 40, 129}}, {128, {183, 55, 121}}, {200, {253, 152, 105}}};
  for (const auto& [entry, expected] : cases) {
    const Rgb rgb = colour_of(static_cast<float>(entry) / 255.0f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], expected[c], 3) << "entry " << entry << " channel " << c;
  }
}

TEST(ErrorMapTest, ScaleIsFixedWhateverElseIsInTheMap) {
  const DisplayImage alone = magma_image({1, 1, {0.3f}});
  const DisplayImage beside_more = magma_image({3, 1, {0.1f, 0.3f, 0.9f}});
  EXPECT_EQ(alone.pixels[0], beside_more.pixels[1]);
}

TEST(ErrorMapTest, LargerErrorsAreBrighter) {
  double last = -1.0;
  for (int i = 0; i <= 255; ++i) {
    const Rgb rgb = colour_of(static_cast<float>(i) / 255.0f);
    const double luma = 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
    EXPECT_GE(luma, last - 0.5) << i;  // each channel is rounded
    last = luma;
  }
}

TEST(ErrorMapTest, ValuesOffTheScaleAreRefused) {
  EXPECT_THROW(colour_of(1.01f), std::invalid_argument);
  EXPECT_THROW(colour_of(-0.01f), std::invalid_argument);
  EXPECT_THROW(colour_of(std::nanf("")), std::invalid_argument);
}

}  // namespace
}  // namespace plume
