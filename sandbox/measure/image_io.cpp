#include "sandbox/measure/image_io.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <half.h>
#include <png.h>
#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <mutex>
#include <new>
#include <span>
#include <stdexcept>

namespace plume {
namespace {

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
std::string png_damage(std::span<const uint8_t> bytes) {
  constexpr size_t kSignature = 8, kLength = 4, kType = 4, kCrc = 4;
  if (bytes.size() < kSignature || png_sig_cmp(bytes.data(), 0, kSignature) != 0) return "not a PNG file";
  for (bytes = bytes.subspan(kSignature); bytes.size() >= kLength + kType + kCrc;) {
    const size_t length = big_endian(bytes.data());
    if (length > bytes.size() - (kLength + kType + kCrc)) break;
    const std::string type(reinterpret_cast<const char*>(bytes.data()) + kLength, kType);
    const uint8_t* crc = bytes.data() + kLength + kType + length;
    if (crc32_z(0, bytes.data() + kLength, kType + length) != big_endian(crc))
      return "damaged PNG: chunk " + type + " fails its checksum";
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

class MemoryInput : public Imf::IStream {
 public:
  explicit MemoryInput(std::span<const uint8_t> bytes) : Imf::IStream("memory"), bytes_(bytes) {}
  bool read(char c[], int n) override {
    if (n < 0 || position_ > bytes_.size() || bytes_.size() - position_ < static_cast<size_t>(n))
      throw std::runtime_error("truncated EXR");
    std::memcpy(c, bytes_.data() + position_, n);
    position_ += n;
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  std::span<const uint8_t> bytes_;
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

// Throws what is wrong with the file, without its path.
Image decode_exr(std::span<const uint8_t> bytes) {
  // The library's only limit is one for the whole process; without it a header could ask for any amount of
  // memory.
  static std::once_flag limit;
  std::call_once(limit, [] { Imf::Header::setMaxImageSize(kMaxImageSide, kMaxImageSide); });
  MemoryInput stream(bytes);
  Imf::InputFile file(stream);
  const Imath::Box2i window = file.header().dataWindow();
  const int64_t width = int64_t{window.max.x} - window.min.x + 1;
  const int64_t height = int64_t{window.max.y} - window.min.y + 1;
  if (const std::string fault = size_fault(width, height); !fault.empty()) throw std::runtime_error(fault);
  for (const char* name : kChannels) {
    const Imf::Channel* channel = file.header().channels().findChannel(name);
    if (!channel) throw std::runtime_error(std::string("no channel ") + name + "; R, G and B are needed");
    if (channel->xSampling != 1 || channel->ySampling != 1)
      throw std::runtime_error(std::string("channel ") + name + " is subsampled; it must be full size");
  }

  // Grown as lines arrive: a small file that claims a huge size must run out of data, not us out of memory.
  constexpr int kLinesAtOnce = 64;
  Image image{static_cast<int>(width), static_cast<int>(height), {}};
  for (int y = 0; y < image.height; y += kLinesAtOnce) {
    const int lines = std::min(kLinesAtOnce, image.height - y);
    const size_t first = image.pixels.size();
    image.pixels.resize(first + static_cast<size_t>(lines) * image.width);
    Imath::Box2i block = window;
    block.min.y = window.min.y + y;
    block.max.y = block.min.y + lines - 1;
    file.setFrameBuffer(frame_buffer(Imf::FLOAT, &image.pixels[first].x, block));
    file.readPixels(block.min.y, block.max.y);
  }
  return image;
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
  const std::vector<uint8_t> bytes = read_file(path);
  if (const std::string damage = png_damage(bytes); !damage.empty()) throw FileError(path, damage);
  PngImage png;
  if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size())) throw FileError(path, png.message);
  if (const std::string fault = size_fault(png.width, png.height); !fault.empty())
    throw FileError(path, fault);
  png.format = PNG_FORMAT_RGBA;
  png.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;

  // Left uninitialised: the pages of a huge claim are only used as far as the file has data for them.
  const std::unique_ptr<uint8_t[]> rgba(new (std::nothrow) uint8_t[PNG_IMAGE_SIZE(png)]);
  if (!rgba) throw FileError(path, "not enough memory for " + size_text(png.width, png.height) + " pixels");
  if (!png_image_finish_read(&png, nullptr, rgba.get(), 0, nullptr)) throw FileError(path, png.message);

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
  const std::vector<uint8_t> bytes = read_file(path);
  try {
    return decode_exr(bytes);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "not enough memory for the image it claims to hold");
  } catch (const std::exception& error) {
    throw FileError(path, error.what());
  }
}

}  // namespace plume
