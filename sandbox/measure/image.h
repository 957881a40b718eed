// The two kinds of picture that are measured: what the renderer computed, and what a display shows of it.
#ifndef PLUME_MEASURE_IMAGE_H
#define PLUME_MEASURE_IMAGE_H

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace plume {

/// Pixels row by row, top-left first. `pixels` holds width * height values.
template <class Pixel>
struct Raster {
  int width = 0;
  int height = 0;
  std::vector<Pixel> pixels;

  /// The pixel at column x, row y, both from 0. Throws std::out_of_range outside the picture.
  Pixel& at(int x, int y) { return pixels.at(index(x, y)); }
  const Pixel& at(int x, int y) const { return pixels.at(index(x, y)); }

 private:
  size_t index(int x, int y) const {
    const bool inside = x >= 0 && y >= 0 && x < width && y < height;
    return inside ? static_cast<size_t>(y) * width + x : pixels.size();
  }
};

/// Linear light, Rec. 709 primaries, unbounded (HDR), what the renderer wrote.
using Image = Raster<glm::vec3>;

/// sRGB as a display takes it, 8 bits a channel.
using DisplayImage = Raster<std::array<uint8_t, 3>>;

/// "640x360", for messages.
std::string size_text(int width, int height);

/// Throws std::invalid_argument unless both pictures have the same size, and pixels.
template <class Pixel>
void require_comparable(const Raster<Pixel>& a, const Raster<Pixel>& b) {
  if (a.width != b.width || a.height != b.height)
    throw std::invalid_argument("cannot compare a " + size_text(a.width, a.height) + " image with a " +
                                size_text(b.width, b.height) + " one: the sizes must be equal");
  if (a.pixels.empty() || a.pixels.size() != b.pixels.size())
    throw std::invalid_argument("cannot compare images without pixels");
}

/// The transfer functions of IEC 61966-2-1 with their linear toe; 0..1 maps onto 0..1.
float srgb_from_linear(float linear);
float linear_from_srgb(float srgb);

/// Encodes for a display: values outside 0..1 saturate, as they would there, and the result is rounded to
/// nearest. A pixel with a NaN turns magenta (255, 0, 255), so that it shows.
DisplayImage to_display(const Image& image);

/// The linear light of a display image, 0..1.
Image to_linear(const DisplayImage& image);

}  // namespace plume
#endif
