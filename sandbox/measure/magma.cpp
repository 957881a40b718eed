#include "sandbox/measure/magma.h"

#include <algorithm>
#include <cstddef>

namespace plume {
namespace {

// Every 15th of the 256 entries of matplotlib's magma (van der Walt and Smith, CC0). Joined by straight lines
// they are within 3/255 of the full table.
constexpr std::array<uint32_t, 18> kMagma{0x000004, 0x090720, 0x1a1042, 0x311165, 0x4a1079, 0x621980,
                                          0x792282, 0x912b81, 0xaa337d, 0xc23b75, 0xd9466b, 0xec5860,
                                          0xf7725c, 0xfc8e64, 0xfeaa74, 0xfec68a, 0xfde2a3, 0xfcfdbf};

}  // namespace

std::array<uint8_t, 3> magma(float share) {
  const float position = share * (kMagma.size() - 1);
  const size_t below = std::min(static_cast<size_t>(position), kMagma.size() - 2);
  const float part = position - static_cast<float>(below);
  std::array<uint8_t, 3> rgb;
  for (int c = 0; c < 3; ++c) {
    const int shift = 16 - 8 * c;
    const float from = static_cast<float>(kMagma[below] >> shift & 0xff);
    const float to = static_cast<float>(kMagma[below + 1] >> shift & 0xff);
    rgb[c] = static_cast<uint8_t>(from + part * (to - from) + 0.5f);
  }
  return rgb;
}

}  // namespace plume
