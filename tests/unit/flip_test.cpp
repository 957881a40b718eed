#include "sandbox/measure/flip.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace plume {
namespace {

using Rgb = std::array<uint8_t, 3>;

DisplayImage paint(int width, int height, const std::function<Rgb(int, int)>& colour) {
  DisplayImage image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) image.pixels.push_back(colour(x, y));
  return image;
}

DisplayImage flat(int width, int height, Rgb colour) {
  return paint(width, height, [&](int, int) { return colour; });
}

DisplayImage noise(int width, int height, unsigned seed) {
  std::mt19937 random(seed);
  return paint(width, height, [&](int, int) {
    const auto bits = static_cast<unsigned>(random());
    return Rgb{static_cast<uint8_t>(bits), static_cast<uint8_t>(bits >> 8), static_cast<uint8_t>(bits >> 16)};
  });
}

DisplayImage transposed(const DisplayImage& image) {
  return paint(image.height, image.width, [&](int x, int y) { return image.at(y, x); });
}

// ---- The paper step by step, in double, each filter as one full two-dimensional sum over its kernel ----

using Vec3 = std::array<double, 3>;
using Weights = std::vector<std::vector<double>>;

const double kToXyz[3][3] = {{10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794},
                             {2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897},
                             {1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382}};

Vec3 xyz_of(const Vec3& rgb) {
  Vec3 xyz{};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) xyz[r] += kToXyz[r][c] * rgb[c];
  return xyz;
}

const Vec3 kWhite = xyz_of({1.0, 1.0, 1.0});

// Cramer's rule.
Vec3 rgb_of(const Vec3& xyz) {
  const auto determinant = [](const double(&m)[3][3]) {
    return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
           m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
           m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  };
  Vec3 rgb;
  for (int c = 0; c < 3; ++c) {
    double replaced[3][3];
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) replaced[i][j] = j == c ? xyz[i] : kToXyz[i][j];
    rgb[c] = determinant(replaced) / determinant(kToXyz);
  }
  return rgb;
}

std::vector<Vec3> ycxcz_of(const DisplayImage& image) {
  std::vector<Vec3> out;
  for (const Rgb& pixel : image.pixels) {
    Vec3 linear;
    for (int c = 0; c < 3; ++c) {
      const double v = pixel[c] / 255.0;
      linear[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    }
    const Vec3 xyz = xyz_of(linear);
    const double x = xyz[0] / kWhite[0], y = xyz[1] / kWhite[1], z = xyz[2] / kWhite[2];
    out.push_back({116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)});
  }
  return out;
}

Vec3 hunt_lab_of(const Vec3& rgb) {
  const auto f = [](double t) {
    return t > std::pow(6.0 / 29.0, 3) ? std::pow(t, 1.0 / 3.0) : t * 29.0 * 29.0 / (3.0 * 36.0) + 4.0 / 29.0;
  };
  const Vec3 xyz = xyz_of(rgb);
  const double fx = f(xyz[0] / kWhite[0]), fy = f(xyz[1] / kWhite[1]), fz = f(xyz[2] / kWhite[2]);
  const double lightness = 116.0 * fy - 16.0;
  return {lightness, 0.01 * lightness * 500.0 * (fx - fy), 0.01 * lightness * 200.0 * (fy - fz)};
}

double compressed_hyab(const Vec3& a, const Vec3& b) {
  return std::pow(std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]), 0.7);
}

double redistributed(double distance) {
  const double largest = compressed_hyab(hunt_lab_of({0, 1, 0}), hunt_lab_of({0, 0, 1}));
  const double knee = 0.4 * largest;
  return distance < knee ? 0.95 / knee * distance : 0.95 + (distance - knee) / (largest - knee) * 0.05;
}

Weights kernel_of(int radius, const std::function<double(int, int)>& weight) {
  Weights kernel(2 * radius + 1, std::vector<double>(2 * radius + 1));
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x) kernel[y + radius][x + radius] = weight(x, y);
  return kernel;
}

// Positive weights to +1, negative ones to -1.
void normalise(Weights& kernel) {
  double positive = 0.0, negative = 0.0;
  for (const auto& row : kernel)
    for (const double w : row) (w > 0.0 ? positive : negative) += std::abs(w);
  for (auto& row : kernel)
    for (double& w : row) w /= w > 0.0 ? positive : negative > 0.0 ? negative : 1.0;
}

double filtered(const std::vector<Vec3>& in, int channel, int width, int height, int x, int y,
                const Weights& kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  double sum = 0.0;
  for (int j = -radius; j <= radius; ++j)
    for (int i = -radius; i <= radius; ++i) {
      const int sx = std::min(std::max(x + i, 0), width - 1), sy = std::min(std::max(y + j, 0), height - 1);
      sum += kernel[j + radius][i + radius] * in[static_cast<size_t>(sy) * width + sx][channel];
    }
  return sum;
}

std::vector<double> flip_by_definition(const DisplayImage& reference, const DisplayImage& test, double ppd) {
  constexpr double kPi = std::numbers::pi;
  const int sensitivity_radius = static_cast<int>(std::ceil(3.0 * std::sqrt(0.04 / (2.0 * kPi * kPi)) * ppd));
  const double terms[3][4] = {{1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};
  Weights sensitivity[3];
  for (int c = 0; c < 3; ++c) {
    const auto& [a1, b1, a2, b2] = terms[c];
    sensitivity[c] = kernel_of(sensitivity_radius, [&, a1 = a1, b1 = b1, a2 = a2, b2 = b2](int x, int y) {
      const double d2 = (x * x + y * y) / (ppd * ppd);
      return a1 * std::sqrt(kPi / b1) * std::exp(-kPi * kPi * d2 / b1) +
             a2 * std::sqrt(kPi / b2) * std::exp(-kPi * kPi * d2 / b2);
    });
    normalise(sensitivity[c]);
  }
  const double sd = 0.5 * 0.082 * ppd;
  const int feature_radius = static_cast<int>(std::ceil(3.0 * sd));
  Weights detectors[4];  // edges in x, edges in y, points in x, points in y
  for (int d = 0; d < 4; ++d) {
    detectors[d] = kernel_of(feature_radius, [&](int x, int y) {
      const double g = std::exp(-(x * x + y * y) / (2.0 * sd * sd));
      const int along = d % 2 == 0 ? x : y;
      return d < 2 ? -along * g : (along * along / (sd * sd) - 1.0) * g;
    });
    normalise(detectors[d]);
  }

  const int width = reference.width, height = reference.height;
  const std::vector<Vec3> opponent[2] = {ycxcz_of(reference), ycxcz_of(test)};
  std::vector<double> map;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      Vec3 lab[2];
      double edge[2], point[2];
      for (int image = 0; image < 2; ++image) {
        const auto response = [&](int channel, const Weights& kernel) {
          return filtered(opponent[image], channel, width, height, x, y, kernel);
        };
        const double yy = (response(0, sensitivity[0]) + 16.0) / 116.0;
        const double cx = response(1, sensitivity[1]) / 500.0, cz = response(2, sensitivity[2]) / 200.0;
        Vec3 rgb = rgb_of({(yy + cx) * kWhite[0], yy * kWhite[1], (yy - cz) * kWhite[2]});
        for (double& v : rgb) v = std::min(std::max(v, 0.0), 1.0);
        lab[image] = hunt_lab_of(rgb);
        // The offset of Yy does not matter to filters that sum to zero.
        edge[image] = std::hypot(response(0, detectors[0]), response(0, detectors[1])) / 116.0;
        point[image] = std::hypot(response(0, detectors[2]), response(0, detectors[3])) / 116.0;
      }
      const double colour = redistributed(compressed_hyab(lab[0], lab[1]));
      const double feature =
          std::sqrt(std::max(std::abs(edge[0] - edge[1]), std::abs(point[0] - point[1])) / std::sqrt(2.0));
      map.push_back(std::pow(colour, 1.0 - feature));
    }
  return map;
}

void expect_definition(const DisplayImage& reference, const DisplayImage& test, double ppd) {
  const FlipResult result = flip(reference, test, ppd);
  const std::vector<double> expected = flip_by_definition(reference, test, ppd);
  ASSERT_EQ(result.map.pixels.size(), expected.size());
  double worst = 0.0, sum = 0.0;
  for (size_t i = 0; i < expected.size(); ++i) {
    worst = std::max(worst, std::abs(result.map.pixels[i] - expected[i]));
    sum += expected[i];
  }
  EXPECT_LT(worst, 1e-4) << reference.width << "x" << reference.height << " at " << ppd;
  EXPECT_NEAR(result.mean, sum / static_cast<double>(expected.size()), 1e-5);
}

TEST(FlipTest, NoiseMatchesTheDefinition) {
  for (const auto& [width, height] : {std::pair{17, 9}, {64, 48}, {1, 1}, {1, 40}, {30, 2}})
    expect_definition(noise(width, height, 1), noise(width, height, 2), kFlipPixelsPerDegree);
}

TEST(FlipTest, FaintNoiseMatchesTheDefinition) {
  const DisplayImage reference = noise(64, 48, 3);
  DisplayImage test = reference;
  for (size_t i = 0; i < test.pixels.size(); i += 2) test.pixels[i][i % 3] ^= 1;
  expect_definition(reference, test, kFlipPixelsPerDegree);
}

TEST(FlipTest, EdgesThatMovedMatchTheDefinition) {
  const auto disc = [](double cx) {
    return paint(64, 48, [cx](int x, int y) {
      return std::hypot(x - cx, y - 24.0) < 15.0 ? Rgb{240, 120, 20} : Rgb{10, 30, 60};
    });
  };
  expect_definition(disc(30.0), disc(33.0), kFlipPixelsPerDegree);
}

TEST(FlipTest, GradientsAndLinesMatchTheDefinition) {
  const auto ramp = [](int x, int y) {
    return Rgb{static_cast<uint8_t>(4 * x), static_cast<uint8_t>(5 * y), static_cast<uint8_t>(2 * x + y)};
  };
  const DisplayImage reference = paint(64, 48, ramp);
  const DisplayImage test = paint(64, 48, [&](int x, int y) {
    return x == 20 || y == 31 || (x * 7 + y * 3) % 41 == 0 ? Rgb{255, 255, 255} : ramp(x, y);
  });
  expect_definition(reference, test, kFlipPixelsPerDegree);
}

TEST(FlipTest, OffsetsWithoutAnyFeatureMatchTheDefinition) {
  const auto ramp = [](int offset) {
    return paint(64, 48, [offset](int x, int) {
      const auto level = static_cast<uint8_t>(x + offset);
      return Rgb{level, level, level};
    });
  };
  expect_definition(ramp(60), ramp(63), kFlipPixelsPerDegree);
  expect_definition(flat(17, 9, {90, 90, 90}), flat(17, 9, {93, 90, 88}), kFlipPixelsPerDegree);
}

TEST(FlipTest, OtherViewingDistancesMatchTheDefinition) {
  for (const double ppd : {1.0, 20.0, 41.5, 120.0})
    expect_definition(noise(33, 21, 4), noise(33, 21, 5), ppd);
}

TEST(FlipTest, IdenticalImagesHaveNoError) {
  const DisplayImage image = noise(40, 30, 6);
  const FlipResult result = flip(image, image);
  EXPECT_EQ(result.mean, 0.0);
  for (const float error : result.map.pixels) ASSERT_EQ(error, 0.0f);
}

TEST(FlipTest, BlackAgainstWhiteIsNearTheEndOfTheScale) {
  // HyAB is 100, the difference in L*. 100^0.7 = 25.119 lies above the knee of 0.4 * 41.276, so
  // 0.95 + 0.05 * (25.119 - 16.510) / (41.276 - 16.510).
  const double by_hand = 0.95 + 0.05 * (25.1188643 - 0.4 * 41.2759868) / (0.6 * 41.2759868);
  const FlipResult result = flip(flat(20, 10, {0, 0, 0}), flat(20, 10, {255, 255, 255}));
  for (const float error : result.map.pixels) ASSERT_NEAR(error, by_hand, 1e-5);
  EXPECT_NEAR(result.mean, 0.96738, 1e-5);
}

TEST(FlipTest, GreenAgainstBlueIsTheEndOfTheScale) {
  const FlipResult result = flip(flat(20, 10, {0, 255, 0}), flat(20, 10, {0, 0, 255}));
  EXPECT_NEAR(result.mean, 1.0, 1e-5);
}

TEST(FlipTest, FlatGreysAreJudgedByLightnessAlone) {
  // L* = 116 cbrt(Y) - 16, and below the knee the error is 0.95 (dL^0.7) / 16.5104.
  const auto lightness = [](int level) {
    return 116.0 * std::cbrt(std::pow((level / 255.0 + 0.055) / 1.055, 2.4)) - 16.0;
  };
  const double expected = 0.95 * std::pow(lightness(128) - lightness(120), 0.7) / (0.4 * 41.2759868);
  const FlipResult result = flip(flat(20, 10, {120, 120, 120}), flat(20, 10, {128, 128, 128}));
  EXPECT_NEAR(result.mean, expected, 1e-5);
}

TEST(FlipTest, OrderOfThePicturesDoesNotMatter) {
  const DisplayImage a = noise(40, 30, 7), b = noise(40, 30, 8);
  EXPECT_EQ(flip(a, b).map.pixels, flip(b, a).map.pixels);
}

TEST(FlipTest, TurningThePicturesTurnsTheMap) {
  const DisplayImage a = noise(37, 22, 9), b = noise(37, 22, 10);
  const FlipResult upright = flip(a, b);
  const FlipResult turned = flip(transposed(a), transposed(b));
  for (int y = 0; y < 22; ++y)
    for (int x = 0; x < 37; ++x) ASSERT_NEAR(upright.map.at(x, y), turned.map.at(y, x), 1e-5);
}

TEST(FlipTest, ErrorsStayOnTheScale) {
  for (unsigned seed = 0; seed < 5; ++seed)
    for (const float error : flip(noise(31, 17, seed), noise(31, 17, seed + 100)).map.pixels) {
      ASSERT_GE(error, 0.0f);
      ASSERT_LE(error, 1.0f);
    }
}

TEST(FlipTest, FineDetailFadesWithDistance) {
  const DisplayImage checks = paint(48, 48, [](int x, int y) {
    return (x + y) % 2 == 0 ? Rgb{255, 255, 255} : Rgb{0, 0, 0};
  });
  const DisplayImage grey = flat(48, 48, {188, 188, 188});  // the same mean in linear light
  const double near = flip(checks, grey, 20.0).mean;
  const double far = flip(checks, grey, 200.0).mean;
  EXPECT_GT(near, 0.5);
  EXPECT_LT(far, 0.05);
}

TEST(FlipTest, AnErrorIsSeenOnlyAroundItsPlace) {
  const DisplayImage reference = flat(80, 60, {60, 60, 60});
  DisplayImage test = reference;
  test.at(25, 40) = {255, 255, 255};
  const FlipResult result = flip(reference, test);
  EXPECT_GT(result.map.at(25, 40), 0.3f);
  for (int y = 0; y < 60; ++y)
    for (int x = 0; x < 80; ++x)
      // The filters reach 10 pixels at the default distance.
      if (std::max(std::abs(x - 25), std::abs(y - 40)) > 10) {
        ASSERT_LT(result.map.at(x, y), 1e-3f) << x << "," << y;
      }
}

TEST(FlipTest, PicturesOfDifferentSizeAreRefused) {
  EXPECT_THROW(flip(flat(4, 2, {}), flat(2, 4, {})), std::invalid_argument);
  EXPECT_THROW(flip({}, {}), std::invalid_argument);
}

TEST(FlipTest, ImpossibleViewingDistancesAreRefused) {
  const DisplayImage image = flat(4, 4, {});
  for (const double ppd : {0.0, -67.0, 0.5, 1001.0, std::nan("")})
    EXPECT_THROW(flip(image, image, ppd), std::invalid_argument) << ppd;
}

}  // namespace
}  // namespace plume
