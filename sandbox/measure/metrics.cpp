#include "sandbox/measure/metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace plume {
namespace {

// A NaN compares false with everything, so left alone it would slip through a maximum as no error at all.
double channel_error(double a, double b) {
  if (a == b) return 0.0;
  const double difference = std::abs(a - b);
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

constexpr int kWindow = 11;

std::array<double, kWindow> gaussian_window() {
  constexpr double kSigma = 1.5;
  std::array<double, kWindow> weights;
  double sum = 0.0;
  for (int i = 0; i < kWindow; ++i) {
    const double distance = i - kWindow / 2;
    weights[i] = std::exp(-distance * distance / (2.0 * kSigma * kSigma));
    sum += weights[i];
  }
  for (double& w : weights) w /= sum;
  return weights;
}

Raster<double> luma(const DisplayImage& image) {
  Raster<double> out{image.width, image.height, {}};
  out.pixels.reserve(image.pixels.size());
  for (const auto& p : image.pixels) out.pixels.push_back(0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2]);
  return out;
}

Raster<double> with_border(const Raster<double>& in, int border) {
  Raster<double> out{in.width + 2 * border, in.height + 2 * border, {}};
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      out.pixels.push_back(
          in.at(std::clamp(x - border, 0, in.width - 1), std::clamp(y - border, 0, in.height - 1)));
  return out;
}

// The window's mean at each place where it lies inside, so kWindow - 1 fewer columns and rows.
Raster<double> window_means(const Raster<double>& in) {
  static const std::array<double, kWindow> kWeights = gaussian_window();
  Raster<double> rows{in.width - kWindow + 1, in.height, {}};
  rows.pixels.reserve(static_cast<size_t>(rows.width) * rows.height);
  for (int y = 0; y < rows.height; ++y)
    for (int x = 0; x < rows.width; ++x) {
      const double* first = &in.pixels[static_cast<size_t>(y) * in.width + x];
      double sum = 0.0;
      for (int i = 0; i < kWindow; ++i) sum += kWeights[i] * first[i];
      rows.pixels.push_back(sum);
    }
  Raster<double> out{rows.width, in.height - kWindow + 1, {}};
  out.pixels.reserve(static_cast<size_t>(out.width) * out.height);
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const double* first = &rows.pixels[static_cast<size_t>(y) * rows.width + x];
      double sum = 0.0;
      for (int i = 0; i < kWindow; ++i) sum += kWeights[i] * first[static_cast<size_t>(i) * rows.width];
      out.pixels.push_back(sum);
    }
  return out;
}

Raster<double> product(const Raster<double>& a, const Raster<double>& b) {
  Raster<double> out{a.width, a.height, {}};
  out.pixels.reserve(a.pixels.size());
  for (size_t i = 0; i < a.pixels.size(); ++i) out.pixels.push_back(a.pixels[i] * b.pixels[i]);
  return out;
}

}  // namespace

double rmse(const Image& a, const Image& b) {
  require_comparable(a, b);
  double sum = 0.0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double error = channel_error(a.pixels[i][c], b.pixels[i][c]);
      sum += error * error;
    }
  return std::sqrt(sum / (3.0 * static_cast<double>(a.pixels.size())));
}

MaxError max_abs(const Image& a, const Image& b) {
  require_comparable(a, b);
  MaxError largest;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (const double error = channel_error(a.pixels[i][c], b.pixels[i][c]); error > largest.value)
        largest = {error, static_cast<int>(i % a.width), static_cast<int>(i / a.width)};
  return largest;
}

double psnr_db(const DisplayImage& a, const DisplayImage& b) {
  require_comparable(a, b);
  double sum = 0.0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double error = a.pixels[i][c] - b.pixels[i][c];
      sum += error * error;
    }
  if (sum == 0.0) return std::numeric_limits<double>::infinity();
  return 10.0 * std::log10(255.0 * 255.0 * 3.0 * static_cast<double>(a.pixels.size()) / sum);
}

double ssim(const DisplayImage& a, const DisplayImage& b) {
  require_comparable(a, b);
  constexpr double kC1 = (0.01 * 255.0) * (0.01 * 255.0);
  constexpr double kC2 = (0.03 * 255.0) * (0.03 * 255.0);
  const int border = std::min(a.width, a.height) < kWindow ? kWindow / 2 : 0;
  const Raster<double> luma_a = with_border(luma(a), border);
  const Raster<double> luma_b = with_border(luma(b), border);
  const Raster<double> mean_a = window_means(luma_a);
  const Raster<double> mean_b = window_means(luma_b);
  const Raster<double> square_a = window_means(product(luma_a, luma_a));
  const Raster<double> square_b = window_means(product(luma_b, luma_b));
  const Raster<double> cross = window_means(product(luma_a, luma_b));
  double sum = 0.0;
  for (size_t i = 0; i < mean_a.pixels.size(); ++i) {
    const double mu_a = mean_a.pixels[i], mu_b = mean_b.pixels[i];
    const double variance_a = square_a.pixels[i] - mu_a * mu_a;
    const double variance_b = square_b.pixels[i] - mu_b * mu_b;
    const double covariance = cross.pixels[i] - mu_a * mu_b;
    sum += (2.0 * mu_a * mu_b + kC1) * (2.0 * covariance + kC2) /
           ((mu_a * mu_a + mu_b * mu_b + kC1) * (variance_a + variance_b + kC2));
  }
  return sum / static_cast<double>(mean_a.pixels.size());
}

}  // namespace plume
