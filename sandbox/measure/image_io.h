// Pictures in files: PNG for what a display shows, OpenEXR for what the renderer computed.
//
// Every reader refuses, with a FileError of path and reason, a file that is missing, truncated, damaged or
// not of its format, and one that claims no pixels or more than kMaxImageSide a side. Every writer writes the
// whole file or nothing (see write_file) and refuses the same sizes with std::invalid_argument.
#ifndef PLUME_MEASURE_IMAGE_IO_H
#define PLUME_MEASURE_IMAGE_IO_H

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "sandbox/measure/decode_exr.h"
#include "sandbox/measure/file_bytes.h"
#include "sandbox/measure/image.h"

namespace plume {

enum class ExrPrecision { kHalf, kFloat };

/// The bytes of a PNG file, 8-bit RGB tagged sRGB, for embedding in a report.
std::vector<uint8_t> png_bytes(const DisplayImage& image);

/// Writes an 8-bit RGB PNG. Throws FileError.
void write_png(const std::filesystem::path& path, const DisplayImage& image);

/// Reads any PNG as 8-bit RGB: grey is repeated over the channels, a palette is looked up, 16 bits are
/// rounded to 8, and alpha is ignored, so a pixel has its stored colour whatever its opacity. Samples are
/// taken as sRGB unless a gAMA chunk says otherwise; then libpng converts them, with a power of 1/2.2 for
/// sRGB.
DisplayImage read_png(const std::filesystem::path& path);
/// The same from the bytes of a file; `path` names it in messages.
DisplayImage read_png_bytes(std::span<const uint8_t> bytes, const std::filesystem::path& path);

/// Writes linear RGB with lossless ZIP compression. Throws FileError, also for a finite value too large for
/// kHalf (65504). Infinities and NaNs are kept: they are what the renderer computed.
void write_exr(const std::filesystem::path& path, const Image& image,
               ExrPrecision precision = ExrPrecision::kFloat);

/// Reads the data window of a flat OpenEXR file with the full-size channels R, G and B (half, float or uint).
/// Other channels and the chromaticities are ignored. The format has checksums for compressed pixels alone:
/// other damage is refused where it makes the file unreadable, and else goes unseen. Tiles have at most
/// kMaxTileSide a side.
Image read_exr(const std::filesystem::path& path);
/// The same from the bytes of a file; `path` names it in messages.
Image read_exr_bytes(std::span<const uint8_t> bytes, const std::filesystem::path& path);

}  // namespace plume
#endif
