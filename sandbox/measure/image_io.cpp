#include "sandbox/measure/image_io.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <half.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>

#include "sandbox/presets/printable.h"

namespace plume {
namespace {

constexpr size_t kLongestReason = 400;  // bytes; libraries quote from the file

static_assert(sizeof(std::array<uint8_t, 3>) == 3 && sizeof(glm::vec3) == 3 * sizeof(float),
              "both libraries are handed packed pixels");

// Why the size is unacceptable, or nothing.
std::string size_fault(int64_t width, int64_t height) {
  if (width > 0 && height > 0 && width <= kMaxImageSide && height <= kMaxImageSide) return {};
  return "the image is " + std::to_string(width) + "x" + std::to_string(height) +
         "; each side must be 1 to " + std::to_string(kMaxImageSide) + " pixels";
}

template <class Pixel>
void require_writable(const Raster<Pixel>& image) {
  if (const std::string fault = size_fault(image.width, image.height); !fault.empty())
    throw std::invalid_argument(fault);
  const size_t expected = static_cast<size_t>(image.width) * image.height;
  if (image.pixels.size() != expected)
    throw std::invalid_argument("a " + size_text(image.width, image.height) + " image has " +
                                std::to_string(image.pixels.size()) + " pixels instead of " +
                                std::to_string(expected));
}

// libpng's simplified API reports through a return value; its full API would longjmp over our destructors.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_image_free(this); }
};

uint32_t big_endian(const uint8_t* bytes) {
  return uint32_t{bytes[0]} << 24 | uint32_t{bytes[1]} << 16 | uint32_t{bytes[2]} << 8 | bytes[3];
}

// libpng stops once it has the last pixel, so damage behind it goes unseen, and it only warns of some damage
// before it. Checking each chunk's sum first makes "it read" mean "it is what was written".
// `data_bytes` is how many bytes of packed pixels there are.
std::string png_damage(std::span<const uint8_t> bytes, uint64_t& data_bytes) {
  constexpr size_t kSignature = 8, kLength = 4, kType = 4, kCrc = 4;
  if (bytes.size() < kSignature || png_sig_cmp(bytes.data(), 0, kSignature) != 0) return "not a PNG file";
  for (bytes = bytes.subspan(kSignature); bytes.size() >= kLength + kType + kCrc;) {
    const size_t length = big_endian(bytes.data());
    if (length > bytes.size() - (kLength + kType + kCrc)) break;
    const std::string type(reinterpret_cast<const char*>(bytes.data()) + kLength, kType);
    const uint8_t* crc = bytes.data() + kLength + kType + length;
    if (crc32_z(0, bytes.data() + kLength, kType + length) != big_endian(crc))
      return "damaged PNG: chunk " + printable(type) + " fails its checksum";
    if (type == "IDAT") data_bytes += length;
    if (type == "IEND") return {};
    bytes = bytes.subspan(kLength + kType + length + kCrc);
  }
  return "truncated PNG";
}

class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}
  void write(const char c[], int n) override {
    bytes_.resize(std::max(bytes_.size(), position_ + n));
    std::memcpy(bytes_.data() + position_, c, n);
    position_ += n;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  const std::vector<uint8_t>& bytes() const { return bytes_; }

 private:
  std::vector<uint8_t> bytes_;
  size_t position_ = 0;
};

constexpr std::array<const char*, 3> kChannels{"R", "G", "B"};

// Describes packed pixels of three samples; OpenEXR addresses them by their window coordinates.
template <class Sample>
Imf::FrameBuffer frame_buffer(Imf::PixelType type, const Sample* first, const Imath::Box2i& window) {
  const size_t x_stride = 3 * sizeof(Sample);
  const size_t y_stride = x_stride * (window.max.x - window.min.x + 1);
  Imf::FrameBuffer frame;
  for (int c = 0; c < 3; ++c) {
    // The library wants one pointer type for reading and writing; it only reads when it writes a file.
    Sample* base = const_cast<Sample*>(first) + c;
    frame.insert(kChannels[c], Imf::Slice::Make(type, base, window, x_stride, y_stride));
  }
  return frame;
}

std::vector<half> halves(const std::filesystem::path& path, const Image& image) {
  std::vector<half> out;
  out.reserve(3 * image.pixels.size());
  for (size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float value = image.pixels[i][c];
      out.emplace_back(value);
      if (std::isfinite(value) && out.back().isInfinity())
        throw FileError(path, "channel " + std::string(kChannels[c]) + " of pixel (" +
                                  std::to_string(i % image.width) + ", " + std::to_string(i / image.width) +
                                  ") is " + std::to_string(value) +
                                  ", more than half precision holds (65504); write it as float");
    }
  return out;
}

}  // namespace

std::vector<uint8_t> png_bytes(const DisplayImage& image) {
  require_writable(image);
  PngImage png;
  png.width = static_cast<uint32_t>(image.width);
  png.height = static_cast<uint32_t>(image.height);
  png.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
  std::vector<uint8_t> bytes(size);
  if (!png_image_write_to_memory(&png, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr))
    throw std::runtime_error(std::string("PNG encoding failed: ") + png.message);
  bytes.resize(size);
  return bytes;
}

void write_png(const std::filesystem::path& path, const DisplayImage& image) {
  write_file(path, png_bytes(image));
}

DisplayImage read_png(const std::filesystem::path& path) {
  return read_png_bytes(read_file(path), path);
}

DisplayImage read_png_bytes(std::span<const uint8_t> bytes, const std::filesystem::path& path) {
  uint64_t data_bytes = 0;
  if (const std::string damage = png_damage(bytes, data_bytes); !damage.empty())
    throw FileError(path, damage);
  PngImage png;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
    throw FileError(path, printable(png.message, kLongestReason));
  if (const std::string fault = size_fault(png.width, png.height); !fault.empty())
    throw FileError(path, fault);
  // Deflate packs 1032 bytes into one at most, and a pixel has at least a bit: no room for what cannot come.
  if (uint64_t{png.width} * png.height > data_bytes * 1032 * 8)
    throw FileError(path, "truncated PNG: " + std::to_string(data_bytes) + " bytes of data cannot hold " +
                              size_text(png.width, png.height) + " pixels");
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;

  // Left uninitialised: pages are only used as far as the file has data for them.
  const std::unique_ptr<uint8_t[]> rgba(new (std::nothrow) uint8_t[PNG_IMAGE_SIZE(png)]);
  if (!rgba) throw FileError(path, "not enough memory for " + size_text(png.width, png.height) + " pixels");
  if (!png_image_finish_read(&png, nullptr, rgba.get(), 0, nullptr))
    throw FileError(path, printable(png.message, kLongestReason));

  DisplayImage image{static_cast<int>(png.width), static_cast<int>(png.height), {}};
  image.pixels.resize(static_cast<size_t>(png.width) * png.height);
  for (size_t i = 0; i < image.pixels.size(); ++i) std::copy_n(&rgba[4 * i], 3, image.pixels[i].begin());
  return image;
}

void write_exr(const std::filesystem::path& path, const Image& image, ExrPrecision precision) {
  require_writable(image);
  const Imf::PixelType type = precision == ExrPrecision::kHalf ? Imf::HALF : Imf::FLOAT;
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : kChannels) header.channels().insert(name, Imf::Channel(type));

  MemoryOutput stream;
  const std::vector<half> half_samples =
      precision == ExrPrecision::kHalf ? halves(path, image) : std::vector<half>{};
  const Imath::Box2i& window = header.dataWindow();
  {
    Imf::OutputFile file(stream, header);
    file.setFrameBuffer(precision == ExrPrecision::kHalf
                            ? frame_buffer(type, half_samples.data(), window)
                            : frame_buffer(type, &image.pixels.front().x, window));
    file.writePixels(image.height);
  }  // the table of line offsets is written as the file closes
  write_file(path, stream.bytes());
}

Image read_exr(const std::filesystem::path& path) {
  return read_exr_bytes(read_file(path), path);
}

Image read_exr_bytes(std::span<const uint8_t> bytes, const std::filesystem::path& path) try {
  return decode_exr(bytes);
} catch (const std::bad_alloc&) {
  throw FileError(path, "not enough memory for the image it claims to hold");
} catch (const std::exception& error) {
  throw FileError(path, printable(error.what(), kLongestReason));
}

}  // namespace plume
