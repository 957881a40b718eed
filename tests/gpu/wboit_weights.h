// The published weights of weighted blending in double precision: equations 7 to 10 of McGuire and Bavoil
// 2013, the blog's colour-aware factor and LearnOpenGL's demo.
#ifndef PLUME_TESTS_WBOIT_WEIGHTS_H
#define PLUME_TESTS_WBOIT_WEIGHTS_H

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <string_view>

namespace plume {

constexpr const char* kWboitWeights[] = {"eq7", "eq8", "eq9", "eq10", "colour_aware", "learnopengl"};

/// Window depth of a conventional projection.
inline double window_depth(double z, double near, double far) {
  return far / (far - near) * (1 - near / z);
}

/// `color` is not premultiplied, `z` the view depth in metres.
inline double wboit_weight(std::string_view name, glm::dvec3 color, double alpha, double z, double near,
                           double far) {
  const double window = window_depth(z, near, far);
  const double eq9 = std::clamp(0.03 / (1e-5 + std::pow(z / 200, 4)), 1e-2, 3e3);
  if (name == "eq7")
    return alpha * std::clamp(10 / (1e-5 + std::pow(z / 5, 2) + std::pow(z / 200, 6)), 1e-2, 3e3);
  if (name == "eq8")
    return alpha * std::clamp(10 / (1e-5 + std::pow(z / 10, 3) + std::pow(z / 200, 6)), 1e-2, 3e3);
  if (name == "eq9") return alpha * eq9;
  if (name == "eq10") return alpha * std::max(1e-2, 3e3 * std::pow(1 - window, 3));
  if (name == "colour_aware") {
    const double brightest = std::max({color.r, color.g, color.b});
    return std::max(std::min(1.0, brightest * alpha), alpha) * eq9;
  }
  return std::clamp(std::pow(std::min(1.0, alpha * 10) + 0.01, 3) * 1e8 * std::pow(1 - window * 0.9, 3), 1e-2,
                    3e3);
}

}  // namespace plume
#endif
