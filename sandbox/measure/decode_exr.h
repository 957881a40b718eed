// Decodes an OpenEXR file with OpenEXRCore, which holds every claim of the file against what the file has.
// The older library of the same project makes room for gigabytes that a header claims, and leaves pixels
// unwritten where compressed data end early.
#ifndef PLUME_MEASURE_DECODE_EXR_H
#define PLUME_MEASURE_DECODE_EXR_H

#include <cstdint>
#include <span>

#include "sandbox/measure/image.h"

namespace plume {

inline constexpr int kMaxImageSide = 32768;  ///< pixels
inline constexpr int kMaxTileSide = 4096;    ///< pixels: room is made for a whole one

/// R, G and B of the first part. Throws std::runtime_error with what is wrong, without a path.
Image decode_exr(std::span<const uint8_t> bytes);

}  // namespace plume
#endif
