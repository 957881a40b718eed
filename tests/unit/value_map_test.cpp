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

TEST(ValueMapTest, JoinedRangesAreThatOfAllNumbers) {
  const auto same = [](const ValueRange& a, const ValueRange& b) {
    EXPECT_EQ(a.least, b.least);
    EXPECT_EQ(a.most, b.most);
    EXPECT_EQ(a.least_positive, b.least_positive);
    EXPECT_EQ(a.sum, b.sum);
    EXPECT_EQ(a.count, b.count);
  };
  const ValueRange a = range_of(row({3, 0, 0.5f})), b = range_of(row({-2, 7})), none = range_of(row({}));
  same(joined(a, b), range_of(row({3, 0, 0.5f, -2, 7})));
  same(joined(a, none), a);
  same(joined(none, b), b);
  same(joined(range_of(row({-1, 0})), b), range_of(row({-1, 0, -2, 7})));
}

/// How bright each pixel of a patch is, above or below its mean: its pattern without its colour.
std::vector<bool> pattern_of(float value) {
  constexpr int kSide = 24;
  const DisplayImage image = class_image({kSide, kSide, std::vector<float>(kSide * kSide, value)});
  double mean = 0;
  for (const auto& [r, g, b] : image.pixels) mean += (r + g + b) / double(kSide * kSide);
  std::vector<bool> bright;
  for (const auto& [r, g, b] : image.pixels) bright.push_back(r + g + b >= mean);
  return bright;
}

TEST(ValueMapTest, ClassesAreToldApartWithoutTheirColours) {
  const std::vector<float> classes{1, 2, 3, 4, kNothing};
  for (const float a : classes)
    for (const float b : classes)
      if (a < b || std::isnan(b) != std::isnan(a)) {
        const auto first = pattern_of(a), second = pattern_of(b);
        size_t same = 0;
        for (size_t i = 0; i < first.size(); ++i) same += first[i] == second[i];
        EXPECT_LT(double(same), 0.8 * double(first.size())) << a << " " << b;
      }
}

TEST(ValueMapTest, KeysToClassesHaveThePicturesTexels) {
  const DisplayImage image = class_image({4, 2, {1, 2, 3, kNothing, 3, 2, 1, kNothing}});
  const auto at = [&](int x, int y) { return image.pixels[size_t(y) * 4 + size_t(x)]; };
  EXPECT_EQ(at(0, 0), class_texel(0, 0, 0));
  EXPECT_EQ(at(1, 0), class_texel(1, 1, 0));
  EXPECT_EQ(at(0, 1), class_texel(2, 0, 1));
  EXPECT_EQ(at(3, 1), absent_texel(3, 1));
}

}  // namespace
}  // namespace plume
