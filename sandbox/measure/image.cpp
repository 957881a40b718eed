#include "sandbox/measure/image.h"

#include <algorithm>
#include <cmath>

namespace plume {

std::string size_text(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

float srgb_from_linear(float linear) {
  return linear <= 0.0031308f ? 12.92f * linear : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

float linear_from_srgb(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

DisplayImage to_display(const Image& image) {
  DisplayImage out{image.width, image.height, {}};
  out.pixels.reserve(image.pixels.size());
  const auto encode = [](float linear) {
    return static_cast<uint8_t>(255.0f * srgb_from_linear(std::clamp(linear, 0.0f, 1.0f)) + 0.5f);
  };
  for (const glm::vec3& p : image.pixels) {
    const bool nan = std::isnan(p.r) || std::isnan(p.g) || std::isnan(p.b);
    out.pixels.push_back(nan ? std::array<uint8_t, 3>{255, 0, 255}
                             : std::array<uint8_t, 3>{encode(p.r), encode(p.g), encode(p.b)});
  }
  return out;
}

Image to_linear(const DisplayImage& image) {
  std::array<float, 256> linear;
  for (size_t i = 0; i < linear.size(); ++i) linear[i] = linear_from_srgb(static_cast<float>(i) / 255.0f);
  Image out{image.width, image.height, {}};
  out.pixels.reserve(image.pixels.size());
  for (const auto& p : image.pixels) out.pixels.emplace_back(linear[p[0]], linear[p[1]], linear[p[2]]);
  return out;
}

}  // namespace plume
