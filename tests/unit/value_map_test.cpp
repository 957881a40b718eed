#include "sandbox/measure/value_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plume {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN(),
                kInfinite = std::numeric_limits<float>::infinity();

Raster<float> row(std::vector<float> values) {
  return {int(values.size()), 1, std::move(values)};
}

TEST(ValueMapTest, RangeIsOfTheNumbersThatAreFinite) {
  const ValueRange found = range_of(row({kNothing, 3, 0, 0.5f, kInfinite, -2}));
  EXPECT_EQ(found.count, 4u);
  EXPECT_EQ(found.least, -2);
  EXPECT_EQ(found.most, 3);
  EXPECT_EQ(found.least_positive, 0.5f);
  EXPECT_EQ(found.sum, 1.5);
}

TEST(ValueMapTest, SharesAndNumbersAreInverse) {
  for (const ValueScale& scale : {ValueScale{-3, 5, false}, ValueScale{0.01f, 50, true}})
    for (const float share : {0.0f, 0.25f, 0.5f, 0.9f, 1.0f})
      EXPECT_NEAR(scale.share_of(scale.value_at(share)), share, 1e-5f);
  EXPECT_FLOAT_EQ((ValueScale{1, 100, true}.value_at(0.5f)), 10);
  EXPECT_FLOAT_EQ((ValueScale{1, 101, false}.value_at(0.5f)), 51);
}

TEST(ValueMapTest, WhatLiesBeyondTheScaleIsAtItsEnd) {
  const ValueScale scale{1, 100, true};
  EXPECT_EQ(scale.share_of(0), 0);
  EXPECT_EQ(scale.share_of(-5), 0);
  EXPECT_EQ(scale.share_of(kInfinite), 1);
}

TEST(ValueMapTest, NoScaleIsEmpty) {
  for (const bool logarithmic : {false, true})
    for (const auto& values : {row({}), row({kNothing}), row({0}), row({7, 7}), row({-1, 0}), row({0, 4})})
      for (const std::optional<glm::vec2>& wanted :
           {std::optional<glm::vec2>(), std::optional(glm::vec2(0, 0)), std::optional(glm::vec2(2, 1))}) {
        const ValueScale scale = scale_over(range_of(values), wanted, logarithmic);
        EXPECT_LT(scale.low, scale.high);
        EXPECT_TRUE(!logarithmic || scale.low > 0);
      }
  const ValueScale from_least = scale_over(range_of(row({0, 0.25f, 8})), {}, true);
  EXPECT_EQ(from_least.low, 0.25f);
  EXPECT_EQ(from_least.high, 8);
}

TEST(ValueMapTest, PixelsWithoutANumberAreStripedAndNoColourOfTheScale) {
  const ValueScale scale{0, 1};
  const DisplayImage image =
      value_image(row({kNothing, kNothing, kNothing, kNothing, kNothing, 0, 1}), scale);
  EXPECT_NE(image.pixels[0], image.pixels[4]);
  EXPECT_EQ(image.pixels[0], image.pixels[3]);
  for (float share = 0; share <= 1; share += 0.001f) {
    const auto colour = value_image(row({share}), scale).pixels[0];
    EXPECT_NE(colour, image.pixels[0]);
    EXPECT_NE(colour, image.pixels[4]);
  }
}

}  // namespace
}  // namespace plume
