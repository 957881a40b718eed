#include "sandbox/measure/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace plume {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Image constant(int width, int height, glm::vec3 value) {
  return {width, height, std::vector<glm::vec3>(static_cast<size_t>(width) * height, value)};
}

DisplayImage grey(int width, int height, uint8_t level) {
  return {width, height,
          std::vector<std::array<uint8_t, 3>>(static_cast<size_t>(width) * height, {level, level, level})};
}

DisplayImage noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  DisplayImage image = grey(width, height, 0);
  for (auto& pixel : image.pixels)
    for (uint8_t& channel : pixel) channel = static_cast<uint8_t>(random());
  return image;
}

TEST(MetricsTest, RmseAveragesOverPixelsAndChannels) {
  const Image a = constant(2, 1, {0.0f, 0.0f, 0.0f});
  const Image b{2, 1, {{3.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.0f}}};
  EXPECT_DOUBLE_EQ(rmse(a, b), std::sqrt(25.0 / 6.0));
}

TEST(MetricsTest, SmallErrorsAreNotLostBesideALargeOne) {
  Image a = constant(64, 64, {0.0f, 0.0f, 0.0f});
  const Image b = constant(64, 64, glm::vec3(0.0009765625f));  // 2^-10, exact
  a.at(0, 0).r = 10000.0f + 0.0009765625f;
  const double large = std::pow(double{a.at(0, 0).r} - 0.0009765625, 2);
  const double small = (3 * 64 * 64 - 1) * std::pow(2.0, -20);
  const double expected = std::sqrt((large + small) / (3 * 64 * 64));
  EXPECT_NEAR(rmse(a, b) / expected, 1.0, 1e-13);
}

TEST(MetricsTest, LargestErrorIsFoundWithItsPlace) {
  Image a = constant(5, 4, glm::vec3(1.0f));
  Image b = a;
  b.at(3, 2).g = 1.25f;
  b.at(1, 3).b = 0.5f;
  const MaxError error = max_abs(a, b);
  EXPECT_EQ(error.value, 0.5);
  EXPECT_EQ(error.x, 1);
  EXPECT_EQ(error.y, 3);
}

TEST(MetricsTest, FirstOfEqualErrorsInReadingOrderIsReported) {
  const Image a = constant(3, 3, glm::vec3(0.0f));
  Image b = a;
  b.at(0, 2).r = b.at(2, 1).r = 1.0f;
  EXPECT_EQ(max_abs(a, b).x, 2);
  EXPECT_EQ(max_abs(a, b).y, 1);
}

TEST(MetricsTest, ANanIsAnInfiniteError) {
  const Image a = constant(2, 2, glm::vec3(1.0f));
  Image bad = a;
  bad.at(1, 0).r = std::nanf("");
  for (const Image& other : {a, bad}) {
    EXPECT_EQ(rmse(other, bad), kInfinity);
    EXPECT_EQ(rmse(bad, other), kInfinity);
    EXPECT_EQ(max_abs(other, bad).value, kInfinity);
    EXPECT_EQ(max_abs(bad, other).x, 1);
  }
}

TEST(MetricsTest, InfinitiesInTheSamePlaceAreEqual) {
  const Image a = constant(2, 2, glm::vec3(kInfinity));
  EXPECT_EQ(rmse(a, a), 0.0);
  EXPECT_EQ(max_abs(a, a).value, 0.0);
  EXPECT_EQ(max_abs(a, constant(2, 2, glm::vec3(1.0f))).value, kInfinity);
}

TEST(MetricsTest, PsnrOfOneStepEverywhereIsKnown) {
  EXPECT_NEAR(psnr_db(grey(8, 8, 100), grey(8, 8, 101)), 20.0 * std::log10(255.0), 1e-12);  // 48.13 dB
  EXPECT_NEAR(psnr_db(grey(8, 8, 0), grey(8, 8, 255)), 0.0, 1e-12);
}

TEST(MetricsTest, PsnrOfIdenticalPicturesIsInfiniteAndNullInJson) {
  const DisplayImage image = noise(9, 7, 1);
  EXPECT_EQ(psnr_db(image, image), std::numeric_limits<double>::infinity());
  EXPECT_EQ(nlohmann::json(psnr_db(image, image)).dump(), "null");
}

TEST(MetricsTest, SsimOfIdenticalPicturesIsOne) {
  for (const auto& [width, height] : {std::pair{40, 30}, {11, 11}, {5, 3}, {1, 1}}) {
    const DisplayImage image = noise(width, height, 2);
    EXPECT_EQ(ssim(image, image), 1.0) << width << "x" << height;
  }
}

TEST(MetricsTest, SsimOfFlatPicturesComparesTheirMeans) {
  const double a = 60.0, b = 200.0, c1 = 2.55 * 2.55;
  const double expected = (2.0 * a * b + c1) / (a * a + b * b + c1);
  EXPECT_NEAR(ssim(grey(20, 16, 60), grey(20, 16, 200)), expected, 1e-9);
  EXPECT_NEAR(ssim(grey(6, 4, 60), grey(6, 4, 200)), expected, 1e-9);
}

TEST(MetricsTest, SsimOfANegativeIsNegative) {
  const DisplayImage image = noise(32, 32, 3);
  DisplayImage negative = image;
  for (auto& pixel : negative.pixels)
    for (uint8_t& channel : pixel) channel = static_cast<uint8_t>(255 - channel);
  EXPECT_LT(ssim(image, negative), -0.5);
}

TEST(MetricsTest, SsimIsSymmetric) {
  const DisplayImage a = noise(25, 19, 4), b = noise(25, 19, 5);
  EXPECT_EQ(ssim(a, b), ssim(b, a));
}

// Equation 13 of the paper term by term: one full 11x11 window for each pixel, centred moments.
double ssim_by_definition(const DisplayImage& a, const DisplayImage& b) {
  const bool clamped = a.width < 11 || a.height < 11;
  const auto luma = [](const DisplayImage& image, int x, int y) {
    const auto& p =
        image.at(std::min(std::max(x, 0), image.width - 1), std::min(std::max(y, 0), image.height - 1));
    return 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  };
  const int margin = clamped ? 0 : 5;
  double total = 0.0;
  int count = 0;
  for (int y = margin; y < a.height - margin; ++y)
    for (int x = margin; x < a.width - margin; ++x) {
      double sum = 0.0, mean_a = 0.0, mean_b = 0.0, variance_a = 0.0, variance_b = 0.0, covariance = 0.0;
      for (const bool moments : {false, true})
        for (int j = -5; j <= 5; ++j)
          for (int i = -5; i <= 5; ++i) {
            const double w = std::exp(-(i * i + j * j) / 4.5);
            const double va = luma(a, x + i, y + j), vb = luma(b, x + i, y + j);
            if (!moments) {
              sum += w;
              mean_a += w * va;
              mean_b += w * vb;
            } else {
              variance_a += w / sum * std::pow(va - mean_a / sum, 2);
              variance_b += w / sum * std::pow(vb - mean_b / sum, 2);
              covariance += w / sum * (va - mean_a / sum) * (vb - mean_b / sum);
            }
          }
      mean_a /= sum;
      mean_b /= sum;
      total += (2 * mean_a * mean_b + 6.5025) * (2 * covariance + 58.5225) /
               ((mean_a * mean_a + mean_b * mean_b + 6.5025) * (variance_a + variance_b + 58.5225));
      ++count;
    }
  return total / count;
}

TEST(MetricsTest, SsimMatchesItsDefinition) {
  for (const auto& [width, height] : {std::pair{23, 17}, {11, 11}, {12, 30}, {10, 30}, {30, 4}, {1, 1}}) {
    const DisplayImage a = noise(width, height, 6);
    DisplayImage b = a;  // related pictures, so that all three factors of the measure are at work
    for (size_t i = 0; i < b.pixels.size(); i += 3) b.pixels[i][1] = static_cast<uint8_t>(b.pixels[i][1] / 2);
    EXPECT_NEAR(ssim(a, b), ssim_by_definition(a, b), 1e-10) << width << "x" << height;
  }
}

TEST(MetricsTest, PicturesOfDifferentSizeAreRefusedWithBothSizes) {
  const Image wide = constant(4, 2, glm::vec3(0.0f)), tall = constant(2, 4, glm::vec3(0.0f));
  EXPECT_THROW(rmse(wide, tall), std::invalid_argument);
  EXPECT_THROW(psnr_db(grey(4, 2, 0), grey(2, 4, 0)), std::invalid_argument);
  EXPECT_THROW(ssim(grey(4, 2, 0), grey(2, 4, 0)), std::invalid_argument);
  try {
    max_abs(wide, tall);
    FAIL() << "not refused";
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("4x2"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("2x4"), std::string::npos) << error.what();
  }
}

TEST(MetricsTest, EmptyPicturesAreRefused) {
  EXPECT_THROW(rmse({}, {}), std::invalid_argument);
  EXPECT_THROW(ssim({}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace plume
