#include "tests/fuzz/image_checks.h"

namespace plume::fuzz {
namespace {

constexpr size_t kFewPixels = 4096;  // writing them takes no longer than reading

uint32_t claimed(Bytes bytes, size_t at) {
  return uint32_t{bytes[at]} << 24 | uint32_t{bytes[at + 1]} << 16 | uint32_t{bytes[at + 2]} << 8 |
         bytes[at + 3];
}

}  // namespace

std::string check_png(Bytes bytes) {
  std::string refusal;
  const auto image = read_or_refuse(read_png_bytes, bytes, refusal);
  if (!image) return refusal;
  require(claimed(bytes, 16) == static_cast<uint32_t>(image->width) &&
              claimed(bytes, 20) == static_cast<uint32_t>(image->height),
          "the image is not of the size that its header says");
  if (image->pixels.size() <= kFewPixels)
    require(read_png_bytes(png_bytes(*image), "again").pixels == image->pixels,
            "written, it reads back otherwise");
  return "read";
}

}  // namespace plume::fuzz
