// The paper's two pipelines and how they meet:
//
//   colour   sRGB -> YyCxCz, filtered by the eye's contrast sensitivity, clamped to the display's gamut,
//            -> L*a*b* with Hunt's effect, HyAB distance, spread over 0..1: dEc
//   feature  edges and points of the luminance that are in one picture only: dEf
//   both     dE = dEc ^ (1 - dEf)
//
// Every filter is a product of one in x and one in y, or a sum of two such products.
#include "sandbox/measure/flip.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <stdexcept>

namespace plume {
namespace {

using Plane = Raster<float>;

// ---- Filters ----

// Weights at distances 0..r of a filter that is the same on both sides up to sign.
struct Kernel {
  enum class Shape { kSmooth, kEdge, kPoint };
  Shape shape;
  std::vector<float> weights;
};

// Adds the taps at distance k on both sides. The edge and point filters sum to zero; written as differences
// they give an exact zero where the picture is flat, which matters because dEf is a square root.
template <Kernel::Shape shape>
void add_taps(float* out, const float* left, const float* centre, const float* right, float weight,
              int width) {
  for (int x = 0; x < width; ++x) {
    if constexpr (shape == Kernel::Shape::kSmooth) out[x] += weight * (left[x] + right[x]);
    if constexpr (shape == Kernel::Shape::kEdge) out[x] += weight * (left[x] - right[x]);
    if constexpr (shape == Kernel::Shape::kPoint)
      out[x] += weight * ((left[x] - centre[x]) + (right[x] - centre[x]));
  }
}

// `row_at(k)` is the row displaced by k pixels along the filter.
template <class RowAt>
void convolve_row(const Kernel& kernel, const RowAt& row_at, float* out, int width) {
  const float* centre = row_at(0);
  const bool smooth = kernel.shape == Kernel::Shape::kSmooth;
  for (int x = 0; x < width; ++x) out[x] = smooth ? kernel.weights[0] * centre[x] : 0.0f;
  for (int k = 1; k < static_cast<int>(kernel.weights.size()); ++k) {
    const float weight = kernel.weights[k];
    const float* left = row_at(-k);
    const float* right = row_at(k);
    switch (kernel.shape) {
      case Kernel::Shape::kSmooth:
        add_taps<Kernel::Shape::kSmooth>(out, left, centre, right, weight, width);
        break;
      case Kernel::Shape::kEdge:
        add_taps<Kernel::Shape::kEdge>(out, left, centre, right, weight, width);
        break;
      case Kernel::Shape::kPoint:
        add_taps<Kernel::Shape::kPoint>(out, left, centre, right, weight, width);
        break;
    }
  }
}

Plane convolve_x(const Plane& in, const Kernel& kernel) {
  Plane out{in.width, in.height, std::vector<float>(in.pixels.size())};
  const int radius = static_cast<int>(kernel.weights.size()) - 1;
  std::vector<float> padded(static_cast<size_t>(in.width) + 2 * radius);
  for (int y = 0; y < in.height; ++y) {
    const float* row = &in.pixels[static_cast<size_t>(y) * in.width];
    std::fill_n(padded.begin(), radius, row[0]);
    std::copy_n(row, in.width, padded.begin() + radius);
    std::fill_n(padded.end() - radius, radius, row[in.width - 1]);
    const auto row_at = [&](int k) { return padded.data() + radius + k; };
    convolve_row(kernel, row_at, &out.pixels[static_cast<size_t>(y) * in.width], in.width);
  }
  return out;
}

Plane convolve_y(const Plane& in, const Kernel& kernel) {
  Plane out{in.width, in.height, std::vector<float>(in.pixels.size())};
  for (int y = 0; y < in.height; ++y) {
    const auto row_at = [&](int k) {
      return &in.pixels[static_cast<size_t>(std::clamp(y + k, 0, in.height - 1)) * in.width];
    };
    convolve_row(kernel, row_at, &out.pixels[static_cast<size_t>(y) * in.width], in.width);
  }
  return out;
}

Plane convolve(const Plane& in, const Kernel& along_x, const Kernel& along_y) {
  return convolve_y(convolve_x(in, along_x), along_y);
}

// ---- Contrast sensitivity ----

// One term a * sqrt(pi / b) * exp(-pi^2 d^2 / b) of a sensitivity in the spatial domain, d in degrees.
struct GaussianTerm {
  double a;
  double b;
};
constexpr GaussianTerm kAchromatic{1.0, 0.0047};
constexpr GaussianTerm kRedGreen{1.0, 0.0053};
constexpr GaussianTerm kBlueYellow[2] = {{34.1, 0.04}, {13.5, 0.025}};

// A term as a filter in x whose weights sum to one, and what its two-dimensional weights summed to before.
struct SensitivityFilter {
  Kernel kernel;
  double weight_2d;
};

SensitivityFilter sensitivity_filter(const GaussianTerm& term, double pixels_per_degree) {
  // All channels have the radius of the widest term: three standard deviations, b = 2 pi^2 sigma^2.
  const double widest = std::sqrt(kBlueYellow[0].b / (2.0 * std::numbers::pi * std::numbers::pi));
  const int radius = static_cast<int>(std::ceil(3.0 * widest * pixels_per_degree));
  std::vector<double> weights(radius + 1);
  for (int k = 0; k <= radius; ++k) {
    const double scaled = std::numbers::pi * k / pixels_per_degree;
    weights[k] = std::exp(-scaled * scaled / term.b);
  }
  const double sum = 2.0 * std::accumulate(weights.begin(), weights.end(), 0.0) - weights[0];
  SensitivityFilter filter{{Kernel::Shape::kSmooth, {}},
                           term.a * std::sqrt(std::numbers::pi / term.b) * sum * sum};
  for (const double w : weights) filter.kernel.weights.push_back(static_cast<float>(w / sum));
  return filter;
}

// ---- Colour, with the primaries of sRGB in exact fractions ----

struct OpponentPlanes {
  Plane y, cx, cz;
};

// To XYZ relative to the display's white, which is (1, 1, 1): each row sums to one.
glm::dmat3 relative_xyz_from_rgb() {
  const glm::dmat3 rows{{10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0},
                        {2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0},
                        {1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0}};
  glm::dmat3 relative;
  for (int r = 0; r < 3; ++r) relative[r] = rows[r] / (rows[r][0] + rows[r][1] + rows[r][2]);
  return glm::transpose(relative);
}

// YyCxCz is 116 Y - 16, 500 (X - Y), 200 (Y - Z). Scale and offset are left out: the filters sum to one, so
// both would only be undone after them.
OpponentPlanes opponent_planes(const DisplayImage& image) {
  const glm::mat3 to_xyz(relative_xyz_from_rgb());
  const Image linear = to_linear(image);
  const Plane blank{image.width, image.height, std::vector<float>(image.pixels.size())};
  OpponentPlanes planes{blank, blank, blank};
  for (size_t i = 0; i < linear.pixels.size(); ++i) {
    const glm::vec3 xyz = to_xyz * linear.pixels[i];
    planes.y.pixels[i] = xyz.y;
    planes.cx.pixels[i] = xyz.x - xyz.y;
    planes.cz.pixels[i] = xyz.y - xyz.z;
  }
  return planes;
}

// L*a*b* of the relative XYZ, with a* and b* scaled by L* / 100: colours look more vivid in bright light
// (Hunt).
glm::vec3 hunt_lab(const glm::vec3& xyz) {
  constexpr float kDelta = 6.0f / 29.0f;
  const auto f = [](float t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3.0f * kDelta * kDelta) + 4.0f / 29.0f;
  };
  const float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
  const float lightness = 116.0f * fy - 16.0f;
  return {lightness, 0.01f * lightness * 500.0f * (fx - fy), 0.01f * lightness * 200.0f * (fy - fz)};
}

float hyab(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = a - b;
  return std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z);
}

// What the eye sees of each pixel at this distance.
Image seen_colours(const OpponentPlanes& planes, double pixels_per_degree) {
  const Kernel achromatic = sensitivity_filter(kAchromatic, pixels_per_degree).kernel;
  const Kernel red_green = sensitivity_filter(kRedGreen, pixels_per_degree).kernel;
  const SensitivityFilter wide = sensitivity_filter(kBlueYellow[0], pixels_per_degree);
  const SensitivityFilter narrow = sensitivity_filter(kBlueYellow[1], pixels_per_degree);
  const float wide_share = static_cast<float>(wide.weight_2d / (wide.weight_2d + narrow.weight_2d));

  const Plane y = convolve(planes.y, achromatic, achromatic);
  const Plane cx = convolve(planes.cx, red_green, red_green);
  const Plane cz_wide = convolve(planes.cz, wide.kernel, wide.kernel);
  const Plane cz_narrow = convolve(planes.cz, narrow.kernel, narrow.kernel);

  const glm::mat3 to_xyz(relative_xyz_from_rgb());
  const glm::mat3 to_rgb(glm::inverse(relative_xyz_from_rgb()));
  Image seen{y.width, y.height, {}};
  seen.pixels.reserve(y.pixels.size());
  for (size_t i = 0; i < y.pixels.size(); ++i) {
    const float cz = wide_share * cz_wide.pixels[i] + (1.0f - wide_share) * cz_narrow.pixels[i];
    const glm::vec3 xyz{y.pixels[i] + cx.pixels[i], y.pixels[i], y.pixels[i] - cz};
    seen.pixels.push_back(hunt_lab(to_xyz * glm::clamp(to_rgb * xyz, 0.0f, 1.0f)));
  }
  return seen;
}

constexpr float kColourExponent = 0.7f;  // qc

// The largest distance there is on a display, green against blue, compressed like all others.
float largest_distance() {
  const glm::mat3 to_xyz(relative_xyz_from_rgb());
  return std::pow(hyab(hunt_lab(to_xyz[1]), hunt_lab(to_xyz[2])), kColourExponent);
}

// Distances up to pc of the largest take the range up to pt, as large ones are hard to tell apart.
float colour_error(const glm::vec3& a, const glm::vec3& b, float largest) {
  constexpr float kShareOfLargest = 0.4f;  // pc
  constexpr float kShareOfRange = 0.95f;   // pt
  const float distance = std::pow(hyab(a, b), kColourExponent);
  const float knee = kShareOfLargest * largest;
  if (distance < knee) return distance * kShareOfRange / knee;
  return kShareOfRange + (distance - knee) / (largest - knee) * (1.0f - kShareOfRange);
}

// ---- Features ----

struct FeatureKernels {
  Kernel smoothing, edge, point;
};

// A Gaussian and its first two derivatives. Positive weights are to sum to 1 and negative ones to -1, in two
// dimensions. The sign depends on the direction of the derivative alone, so it is enough to do so along it
// and to normalise the smoothing across it.
FeatureKernels feature_kernels(double pixels_per_degree) {
  constexpr double kPeakToTrough = 0.082;  // degrees, twice the standard deviation
  const double sigma = 0.5 * kPeakToTrough * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> smoothing, edge, point;
  double smoothing_sum = 0.0, edge_sum = 0.0, positive_point_sum = 0.0, negative_point_sum = 0.0;
  for (int k = 0; k <= radius; ++k) {
    const double squared = k * k / (sigma * sigma);
    const double gaussian = std::exp(-0.5 * squared);
    const double sides = k == 0 ? 1.0 : 2.0;
    smoothing.push_back(gaussian);
    edge.push_back(k * gaussian);
    point.push_back((squared - 1.0) * gaussian);
    smoothing_sum += sides * smoothing[k];
    edge_sum += edge[k];
    (point[k] > 0.0 ? positive_point_sum : negative_point_sum) += sides * std::abs(point[k]);
  }
  FeatureKernels kernels{
      {Kernel::Shape::kSmooth, {}}, {Kernel::Shape::kEdge, {}}, {Kernel::Shape::kPoint, {}}};
  for (int k = 0; k <= radius; ++k) {
    const double point_sum = point[k] > 0.0 ? positive_point_sum : negative_point_sum;
    kernels.smoothing.weights.push_back(static_cast<float>(smoothing[k] / smoothing_sum));
    kernels.edge.weights.push_back(static_cast<float>(edge[k] / edge_sum));
    kernels.point.weights.push_back(static_cast<float>(point[k] / point_sum));
  }
  return kernels;
}

struct Features {
  Plane edges, points;  // magnitudes over both directions, of luminance 0..1
};

Features features(const Plane& luminance, double pixels_per_degree) {
  const FeatureKernels kernels = feature_kernels(pixels_per_degree);
  const auto magnitude = [&](const Kernel& detector) {
    Plane x = convolve(luminance, detector, kernels.smoothing);
    const Plane y = convolve(luminance, kernels.smoothing, detector);
    for (size_t i = 0; i < x.pixels.size(); ++i)
      x.pixels[i] = std::sqrt(x.pixels[i] * x.pixels[i] + y.pixels[i] * y.pixels[i]);
    return x;
  };
  return {magnitude(kernels.edge), magnitude(kernels.point)};
}

float feature_error(float edge_a, float edge_b, float point_a, float point_b) {
  const float difference = std::max(std::abs(edge_a - edge_b), std::abs(point_a - point_b));
  return std::min(1.0f, std::sqrt(difference / std::numbers::sqrt2_v<float>));  // qf = 0.5
}

}  // namespace

FlipResult flip(const DisplayImage& reference, const DisplayImage& test, double pixels_per_degree) {
  require_comparable(reference, test);
  if (!(pixels_per_degree >= 1.0 && pixels_per_degree <= 1000.0))
    throw std::invalid_argument("FLIP at " + std::to_string(pixels_per_degree) +
                                " pixels per degree: 1 to 1000 is possible");

  const OpponentPlanes opponent_a = opponent_planes(reference);
  const OpponentPlanes opponent_b = opponent_planes(test);
  const Image seen_a = seen_colours(opponent_a, pixels_per_degree);
  const Image seen_b = seen_colours(opponent_b, pixels_per_degree);
  const Features features_a = features(opponent_a.y, pixels_per_degree);
  const Features features_b = features(opponent_b.y, pixels_per_degree);

  const float largest = largest_distance();
  FlipResult result{{reference.width, reference.height, {}}, 0.0};
  result.map.pixels.reserve(reference.pixels.size());
  double sum = 0.0;
  for (size_t i = 0; i < reference.pixels.size(); ++i) {
    const float colour = colour_error(seen_a.pixels[i], seen_b.pixels[i], largest);
    const float feature = feature_error(features_a.edges.pixels[i], features_b.edges.pixels[i],
                                        features_a.points.pixels[i], features_b.points.pixels[i]);
    // Rounding may carry green against blue a little past the end of the scale.
    const float error = colour == 0.0f ? 0.0f : std::min(1.0f, std::pow(colour, 1.0f - feature));
    result.map.pixels.push_back(error);
    sum += error;
  }
  result.mean = sum / static_cast<double>(result.map.pixels.size());
  return result;
}

}  // namespace plume
