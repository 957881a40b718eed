#include "sandbox/measure/small_picture.h"

#include <algorithm>
#include <cmath>

namespace plume {

DisplayImage small_picture(const DisplayImage& picture, glm::uvec2 size) {
  if (picture.pixels.empty()) throw std::invalid_argument("a picture without pixels cannot be made smaller");
  const glm::dvec2 whole(picture.width, picture.height), wanted(size);
  const glm::dvec2 shown = wanted * std::min(whole.x / wanted.x, whole.y / wanted.y);
  const glm::dvec2 corner = 0.5 * (whole - shown), step = shown / wanted;
  std::array<float, 256> linear{};
  for (size_t i = 0; i < linear.size(); ++i) linear[i] = linear_from_srgb(float(i) / 255);
  DisplayImage result{int(size.x), int(size.y), {}};
  for (uint32_t y = 0; y < size.y; ++y)
    for (uint32_t x = 0; x < size.x; ++x) {
      const glm::dvec2 first = corner + glm::dvec2(x, y) * step;
      const glm::ivec2 from(first), to = glm::max(glm::ivec2(first + step), from + 1);
      glm::dvec3 sum(0.0);
      double count = 0;
      for (int v = from.y; v < std::min(to.y, picture.height); ++v)
        for (int u = from.x; u < std::min(to.x, picture.width); ++u, ++count) {
          const auto& [r, g, b] = picture.at(u, v);
          sum += glm::dvec3(linear[r], linear[g], linear[b]);
        }
      const auto byte = [&](double channel) {
        return uint8_t(std::lround(255 * srgb_from_linear(float(channel / count))));
      };
      result.pixels.push_back({byte(sum.r), byte(sum.g), byte(sum.b)});
    }
  return result;
}

}  // namespace plume
