#include "sandbox/measure/image_io.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>

#include <cmath>
#include <csignal>
#include <fstream>
#include <limits>
#include <random>

namespace plume {
namespace {

namespace fs = std::filesystem;
using Rgb = std::array<uint8_t, 3>;

class ImageIoTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              (std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()) + "-" +
               std::to_string(::getpid()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path in_folder(const std::string& name) const { return folder_ / name; }

  size_t files_in_folder() const {
    return static_cast<size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}));
  }

  fs::path holding(const std::string& name, std::span<const uint8_t> bytes) const {
    write_file(in_folder(name), bytes);
    return in_folder(name);
  }

 private:
  fs::path folder_;
};

using PngTest = ImageIoTest;
using ExrTest = ImageIoTest;

// Runs `read` and gives the message of the FileError it must throw.
template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const FileError& error) {
    return error.what();
  }
  ADD_FAILURE() << "was not refused";
  return {};
}

void expect_contains(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "\"" << part << "\" is not in: " << text;
}

DisplayImage noise(int width, int height) {
  std::mt19937 random(11);
  DisplayImage image{width, height, std::vector<Rgb>(static_cast<size_t>(width) * height)};
  for (Rgb& pixel : image.pixels)
    for (uint8_t& channel : pixel) channel = static_cast<uint8_t>(random());
  return image;
}

Image hdr_noise(int width, int height) {
  std::mt19937 random(12);
  std::lognormal_distribution<float> radiance(0.0f, 3.0f);
  Image image{width, height, std::vector<glm::vec3>(static_cast<size_t>(width) * height)};
  for (glm::vec3& pixel : image.pixels) pixel = {radiance(random), radiance(random), -radiance(random)};
  return image;
}

// ---- PNG files of every kind, written by libpng itself ----

struct PngKind {
  int colour_type;
  int bit_depth;
  int width;
  std::vector<uint8_t> row;
  std::vector<png_color> palette = {};
  double gamma = 0.0;  // 0 writes no gAMA chunk
};

std::vector<uint8_t> one_row_png(const PngKind& kind) {
  std::vector<uint8_t> bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp p, png_bytep data, size_t size) {
        auto* out = static_cast<std::vector<uint8_t>*>(png_get_io_ptr(p));
        out->insert(out->end(), data, data + size);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(kind.width), 1, kind.bit_depth, kind.colour_type,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!kind.palette.empty())
    png_set_PLTE(png, info, kind.palette.data(), static_cast<int>(kind.palette.size()));
  if (kind.gamma > 0.0) png_set_gAMA(png, info, kind.gamma);
  png_write_info(png, info);
  png_write_row(png, kind.row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

// Claims another size in an otherwise valid file: the header is the first chunk, and its checksum is renewed.
std::vector<uint8_t> with_claimed_size(std::vector<uint8_t> png, uint32_t width, uint32_t height) {
  for (int i = 0; i < 4; ++i) {
    png[16 + i] = static_cast<uint8_t>(width >> (24 - 8 * i));
    png[20 + i] = static_cast<uint8_t>(height >> (24 - 8 * i));
  }
  const auto crc = static_cast<uint32_t>(crc32(0, &png[12], 17));
  for (int i = 0; i < 4; ++i) png[29 + i] = static_cast<uint8_t>(crc >> (24 - 8 * i));
  return png;
}

TEST_F(PngTest, EveryPixelSurvives) {
  const DisplayImage image = noise(37, 23);
  write_png(in_folder("a.png"), image);
  const DisplayImage back = read_png(in_folder("a.png"));
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 23);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST_F(PngTest, BytesForEmbeddingAreTheFile) {
  const DisplayImage image = noise(8, 8);
  write_png(in_folder("a.png"), image);
  EXPECT_EQ(png_bytes(image), read_file(in_folder("a.png")));
}

TEST_F(PngTest, GreyIsRepeatedOverTheChannels) {
  const auto path = holding("grey.png", one_row_png({PNG_COLOR_TYPE_GRAY, 8, 3, {0, 100, 255}}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{0, 0, 0}, {100, 100, 100}, {255, 255, 255}}));
}

TEST_F(PngTest, OneBitGreyIsBlackAndWhite) {
  const auto path = holding("bits.png", one_row_png({PNG_COLOR_TYPE_GRAY, 1, 3, {0b01000000}}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{0, 0, 0}, {255, 255, 255}, {0, 0, 0}}));
}

TEST_F(PngTest, PaletteIsLookedUp) {
  const auto path = holding(
      "palette.png", one_row_png({PNG_COLOR_TYPE_PALETTE, 8, 2, {1, 0}, {{10, 20, 30}, {200, 150, 100}}}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{200, 150, 100}, {10, 20, 30}}));
}

TEST_F(PngTest, AlphaIsIgnored) {
  const auto path =
      holding("alpha.png", one_row_png({PNG_COLOR_TYPE_RGB_ALPHA, 8, 2, {9, 90, 190, 0, 8, 80, 180, 128}}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{9, 90, 190}, {8, 80, 180}}));
}

TEST_F(PngTest, SixteenBitsAreRoundedToEight) {
  // 0x12ff / 257 = 18.92, where dropping the low byte would give 18.
  const auto path = holding(
      "deep.png",
      one_row_png(
          {PNG_COLOR_TYPE_RGB, 16, 2, {0, 0, 0x12, 0xff, 0x7f, 0xff, 0x80, 0, 0x12, 0x34, 0xff, 0xff}}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{0, 19, 127}, {128, 18, 255}}));
}

TEST_F(PngTest, StatedGammaIsConvertedToSrgb) {
  // libpng's curve for sRGB is a power of 1/2.2.
  const auto path = holding("linear.png", one_row_png({PNG_COLOR_TYPE_GRAY, 8, 1, {128}, {}, 1.0}));
  EXPECT_NEAR(read_png(path).pixels[0][0], 255.0f * srgb_from_linear(128.0f / 255.0f), 2.0);
}

TEST_F(PngTest, GammaThatMeansSrgbChangesNothing) {
  const auto path = holding("srgb.png", one_row_png({PNG_COLOR_TYPE_GRAY, 8, 3, {1, 100, 200}, {}, 0.45455}));
  EXPECT_EQ(read_png(path).pixels, (std::vector<Rgb>{{1, 1, 1}, {100, 100, 100}, {200, 200, 200}}));
}

TEST_F(PngTest, MissingFileIsNamedWithTheReason) {
  const std::string message = refusal([&] { read_png(in_folder("absent.png")); });
  expect_contains(message, in_folder("absent.png").string());
  expect_contains(message, "No such file or directory");
}

TEST_F(PngTest, FolderIsNoPicture) {
  expect_contains(refusal([&] { read_png(in_folder("")); }), "Is a directory");
}

TEST_F(PngTest, OtherFilesAreRefused) {
  const std::string text = "P6 2 2 255 not this one";
  const auto path = holding("a.png", {reinterpret_cast<const uint8_t*>(text.data()), text.size()});
  expect_contains(refusal([&] { read_png(path); }), "not a PNG file");
  expect_contains(refusal([&] { read_png(holding("empty.png", {})); }), "not a PNG file");
}

TEST_F(PngTest, EveryTruncationIsRefused) {
  const std::vector<uint8_t> whole = png_bytes(noise(9, 5));
  for (size_t length = 0; length < whole.size(); ++length) {
    const auto path = holding("cut.png", std::span(whole).first(length));
    expect_contains(refusal([&] { read_png(path); }), "cut.png");
  }
}

TEST_F(PngTest, EveryDamagedByteIsRefused) {
  const std::vector<uint8_t> whole = png_bytes(noise(9, 5));
  for (size_t i = 0; i < whole.size(); ++i) {
    std::vector<uint8_t> damaged = whole;
    damaged[i] ^= 0x10;
    const auto path = holding("damaged.png", damaged);
    expect_contains(refusal([&] { read_png(path); }), "damaged.png");
  }
}

TEST_F(PngTest, MissingImageDataIsRefused) {
  // All chunks are sound, but there is data for 5 rows where the header has 6.
  const auto path = holding("short.png", with_claimed_size(png_bytes(noise(9, 5)), 9, 6));
  expect_contains(refusal([&] { read_png(path); }), "short.png");
}

TEST_F(PngTest, ImpossibleSizesAreRefused) {
  const std::vector<uint8_t> png = png_bytes(noise(4, 4));
  for (const auto& [width, height] : {std::pair{0u, 4u},
                                      {4u, 0u},
                                      {0u, 0u},
                                      {32769u, 4u},
                                      {4u, 32769u},
                                      {0x7fffffffu, 0x7fffffffu},
                                      {0xffffffffu, 1u}}) {
    const auto path = holding("size.png", with_claimed_size(png, width, height));
    expect_contains(refusal([&] { read_png(path); }), "size.png");
  }
  expect_contains(refusal([&] { read_png(holding("size.png", with_claimed_size(png, 40000, 4))); }),
                  "40000x4");
}

TEST_F(PngTest, HugeClaimWithoutDataIsRefused) {
  const auto path = holding("huge.png", with_claimed_size(png_bytes(noise(4, 4)), 32768, 32768));
  const std::string message = refusal([&] { read_png(path); });
  expect_contains(message, "huge.png");
  expect_contains(message, "bytes of data cannot hold 32768x32768 pixels");
}

TEST_F(PngTest, AllThatDeflateCanPackIsRead) {
  const DisplayImage black{3000, 2000, std::vector<Rgb>(6'000'000)};
  EXPECT_EQ(read_png_bytes(png_bytes(black), "black").pixels, black.pixels);
  std::vector<uint8_t> row(4096);  // of 32768 pixels of one bit
  EXPECT_EQ(read_png_bytes(one_row_png({PNG_COLOR_TYPE_GRAY, 1, 32768, row}), "bits").width, 32768);
}

TEST_F(PngTest, PicturesThatCannotBeReadBackAreNotWritten) {
  EXPECT_THROW(write_png(in_folder("a.png"), {}), std::invalid_argument);
  EXPECT_THROW(write_png(in_folder("a.png"), {2, 2, std::vector<Rgb>(3)}), std::invalid_argument);
  EXPECT_THROW(write_png(in_folder("a.png"), {kMaxImageSide + 1, 1, std::vector<Rgb>(kMaxImageSide + 1)}),
               std::invalid_argument);
  EXPECT_EQ(files_in_folder(), 0u);
}

// ---- Writing whole files or nothing ----

TEST_F(ImageIoTest, WritingReplacesTheOldFileAndLeavesNothingBeside) {
  write_png(in_folder("a.png"), noise(4, 4));
  write_png(in_folder("a.png"), noise(6, 3));
  EXPECT_EQ(read_png(in_folder("a.png")).width, 6);
  EXPECT_EQ(files_in_folder(), 1u);
}

TEST_F(ImageIoTest, MissingFolderIsNamedWithTheReason) {
  const fs::path path = in_folder("no/such/a.png");
  const std::string message = refusal([&] { write_png(path, noise(4, 4)); });
  expect_contains(message, path.string());
  expect_contains(message, "No such file or directory");
}

TEST_F(ImageIoTest, FailedRenameLeavesNothingBehind) {
  fs::create_directory(in_folder("a.exr"));
  const std::string message = refusal([&] { write_exr(in_folder("a.exr"), hdr_noise(4, 4)); });
  expect_contains(message, "Is a directory");
  EXPECT_EQ(files_in_folder(), 1u);
}

// A full disk, as far as one can be had without privileges: no file may grow beyond `bytes`.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(ImageIoTest, WriteThatFailsHalfwayKeepsTheOldFile) {
  const DisplayImage old = noise(4, 4);
  write_png(in_folder("a.png"), old);
  std::string message;
  {
    const FileSizeLimit limit(1000);
    message = refusal([&] { write_png(in_folder("a.png"), noise(64, 64)); });
  }
  expect_contains(message, in_folder("a.png").string());
  expect_contains(message, "File too large");
  EXPECT_EQ(read_png(in_folder("a.png")).pixels, old.pixels);
  EXPECT_EQ(files_in_folder(), 1u);
}

// ---- EXR ----

TEST_F(ExrTest, FloatsSurviveBitForBit) {
  const Image image = hdr_noise(37, 150);  // more lines than are read at once
  write_exr(in_folder("a.exr"), image);
  const Image back = read_exr(in_folder("a.exr"));
  EXPECT_EQ(back.width, 37);
  EXPECT_EQ(back.height, 150);
  EXPECT_EQ(back.pixels, image.pixels);
}

TEST_F(ExrTest, NansAndInfinitiesSurvive) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const Image image{1, 1, {{std::nanf(""), kInfinity, -kInfinity}}};
  for (const ExrPrecision precision : {ExrPrecision::kHalf, ExrPrecision::kFloat}) {
    write_exr(in_folder("a.exr"), image, precision);
    const glm::vec3 pixel = read_exr(in_folder("a.exr")).pixels[0];
    EXPECT_TRUE(std::isnan(pixel.r));
    EXPECT_EQ(pixel.g, kInfinity);
    EXPECT_EQ(pixel.b, -kInfinity);
  }
}

TEST_F(ExrTest, HalvesHoldElevenBits) {
  const Image image{2, 1, {{1.0f, 65504.0f, -0.25f}, {1.0f / 3.0f, 0.1f, 1000.4f}}};
  write_exr(in_folder("a.exr"), image, ExrPrecision::kHalf);
  const Image back = read_exr(in_folder("a.exr"));
  EXPECT_EQ(back.pixels[0], image.pixels[0]);
  EXPECT_NE(back.pixels[1], image.pixels[1]);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(back.pixels[1][c] / image.pixels[1][c], 1.0, std::exp2(-11.0));
}

TEST_F(ExrTest, ValueTooLargeForHalfIsNamed) {
  Image image = {3, 2, std::vector<glm::vec3>(6)};
  image.at(2, 1).g = 70000.0f;
  const std::string message = refusal([&] { write_exr(in_folder("a.exr"), image, ExrPrecision::kHalf); });
  expect_contains(message, "channel G of pixel (2, 1)");
  expect_contains(message, "70000");
  EXPECT_EQ(files_in_folder(), 0u);
}

// One channel set in a chosen window, written by OpenEXR itself.
fs::path exr_with(const fs::path& path, const std::vector<std::string>& names, const Imath::Box2i& window) {
  Imf::Header header(Imath::Box2i({0, 0}, {99, 99}), window);
  Imf::FrameBuffer frame;
  const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
  std::vector<std::vector<float>> channels;
  for (size_t c = 0; c < names.size(); ++c) {
    header.channels().insert(names[c], Imf::Channel(Imf::FLOAT));
    channels.emplace_back(static_cast<size_t>(width) * height);
    for (size_t i = 0; i < channels[c].size(); ++i) channels[c][i] = static_cast<float>(1000 * c + i);
  }
  for (size_t c = 0; c < names.size(); ++c)
    frame.insert(names[c], Imf::Slice::Make(Imf::FLOAT, channels[c].data(), window));
  Imf::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(frame);
  file.writePixels(height);
  return path;
}

TEST_F(ExrTest, DataWindowIsReadWhereverItLies) {
  const Image image = read_exr(exr_with(in_folder("a.exr"), {"R", "G", "B", "A"}, {{-5, 7}, {-2, 8}}));
  ASSERT_EQ(image.width, 4);
  ASSERT_EQ(image.height, 2);
  EXPECT_EQ(image.at(0, 0), glm::vec3(0.0f, 1000.0f, 2000.0f));
  EXPECT_EQ(image.at(3, 1), glm::vec3(7.0f, 1007.0f, 2007.0f));
}

// So many bytes more than now, and no more, can be had.
class MemoryLimit {
 public:
  explicit MemoryLimit(rlim_t more) {
    rlim_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    ::getrlimit(RLIMIT_AS, &before_);
    const rlimit limit{pages * static_cast<rlim_t>(::getpagesize()) + more, before_.rlim_max};
    ::setrlimit(RLIMIT_AS, &limit);
  }
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;
  ~MemoryLimit() { ::setrlimit(RLIMIT_AS, &before_); }

 private:
  rlimit before_{};
};

// Of files in which a fuzzer found that OpenEXR's older library makes room for gigabytes, or worse.
std::string refusal_of_found(const std::string& name) {
  return refusal([&] { read_exr(fs::path(PLUME_SOURCE_TESTS) / "fuzz/corpus/exr" / name); });
}

TEST_F(ExrTest, NoRoomIsMadeForClaimsThatTheFileDoesNotHold) {
  const MemoryLimit limit(rlim_t{64} << 20);
  expect_contains(refusal_of_found("text_claims_461_MiB.exr"), "Invalid size 483917825");
  expect_contains(refusal_of_found("opaque_value_claims_1559_MiB.exr"), "End of file");
  expect_contains(refusal_of_found("tile_33554436_high.exr"), "exceeds max size (33554436 vs max 4096)");
  expect_contains(refusal_of_found("claims_32768x32768.exr"), "too big for file size");
}

TEST_F(ExrTest, PixelsThatCompressedDataDoNotReachAreNotMadeUp) {
  expect_contains(refusal_of_found("lines_short_of_pixels.exr"), "Unable to decompress image data");
}

TEST_F(ExrTest, EveryCompressionAndLayoutIsReadAsTheOlderLibraryReadsIt) {
  for (const char* name : {"none",      "rle",   "zips",      "zip",          "piz",
                           "pxr24",     "b44",   "b44a",      "dwaa",         "dwab",
                           "half",      "float", "uint",      "upside_down",  "window_more_channels",
                           "multipart", "tiled", "tiled_zip", "tiled_mipmap", "tiled_ripmap"}) {
    SCOPED_TRACE(name);
    const fs::path path = fs::path(PLUME_SOURCE_TESTS) / "fuzz/corpus/exr" / (std::string(name) + ".exr");
    const Image image = read_exr(path);
    Imf::InputFile file(path.c_str());
    const Imath::Box2i window = file.header().dataWindow();
    ASSERT_EQ(image.width, window.max.x - window.min.x + 1);
    ASSERT_EQ(image.height, window.max.y - window.min.y + 1);
    Image expected{image.width, image.height, std::vector<glm::vec3>(image.pixels.size())};
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c)
      frame.insert(std::string(1, "RGB"[c]),
                   Imf::Slice::Make(Imf::FLOAT, &expected.pixels[0][c], window, sizeof(glm::vec3),
                                    sizeof(glm::vec3) * static_cast<size_t>(image.width)));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    EXPECT_EQ(image.pixels, expected.pixels);
    EXPECT_NE(image.pixels[0], image.pixels[1]);
  }
}

TEST_F(ExrTest, DeepImagesAreRefused) {
  expect_contains(refusal_of_found("deep.exr"), "a flat one is needed");
}

TEST_F(ExrTest, MissingChannelIsNamed) {
  const auto path = exr_with(in_folder("y.exr"), {"Y"}, {{0, 0}, {3, 3}});
  expect_contains(refusal([&] { read_exr(path); }), "no channel R");
}

TEST_F(ExrTest, MissingFileIsNamedWithTheReason) {
  const std::string message = refusal([&] { read_exr(in_folder("absent.exr")); });
  expect_contains(message, in_folder("absent.exr").string());
  expect_contains(message, "No such file or directory");
}

TEST_F(ExrTest, OtherFilesAreRefused) {
  write_png(in_folder("a.exr"), noise(16, 16));
  expect_contains(refusal([&] { read_exr(in_folder("a.exr")); }), "a.exr");
  expect_contains(refusal([&] { read_exr(holding("empty.exr", {})); }), "not an EXR file");
}

TEST_F(ExrTest, EveryTruncationIsRefused) {
  write_exr(in_folder("whole.exr"), hdr_noise(9, 40));
  const std::vector<uint8_t> whole = read_file(in_folder("whole.exr"));
  for (size_t length = 0; length < whole.size(); ++length) {
    const auto path = holding("cut.exr", std::span(whole).first(length));
    expect_contains(refusal([&] { read_exr(path); }), "cut.exr");
  }
}

TEST_F(ExrTest, DamageIsRefusedOrReadButNeverCrashes) {
  // Pixels that compress well, as those that do not are stored without a checksum.
  Image image{64, 64, {}};
  for (int i = 0; i < 64 * 64; ++i) image.pixels.emplace_back(static_cast<float>(i / 5 % 17));
  write_exr(in_folder("whole.exr"), image);
  const std::vector<uint8_t> whole = read_file(in_folder("whole.exr"));
  size_t refused = 0;
  for (size_t i = 0; i < whole.size(); ++i)
    for (const int flip : {0x01, 0x80, 0xff}) {
      std::vector<uint8_t> damaged = whole;
      damaged[i] ^= static_cast<uint8_t>(flip);
      try {
        read_exr(holding("damaged.exr", damaged));
      } catch (const FileError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 3 * whole.size() / 2);
}

TEST_F(ExrTest, ImpossibleSizesAreRefused) {
  write_exr(in_folder("whole.exr"), hdr_noise(4, 4));
  const std::vector<uint8_t> whole = read_file(in_folder("whole.exr"));
  const std::string attribute("dataWindow\0box2i\0\x10\0\0\0", 21);
  const auto at = std::search(whole.begin(), whole.end(), attribute.begin(), attribute.end());
  ASSERT_NE(at, whole.end());
  const size_t window = static_cast<size_t>(at - whole.begin()) + attribute.size();
  for (const auto& [x, y] : {std::pair{kMaxImageSide, 3},
                             {3, kMaxImageSide},
                             {0x7fffffff, 0x7fffffff},
                             {-1, 3},
                             {3, -1},
                             {kMaxImageSide - 1, kMaxImageSide - 1}}) {
    std::vector<uint8_t> claimed = whole;
    for (int i = 0; i < 4; ++i) {
      claimed[window + 8 + i] = static_cast<uint8_t>(static_cast<uint32_t>(x) >> (8 * i));
      claimed[window + 12 + i] = static_cast<uint8_t>(static_cast<uint32_t>(y) >> (8 * i));
    }
    expect_contains(refusal([&] { read_exr(holding("size.exr", claimed)); }), "size.exr");
  }
}

}  // namespace
}  // namespace plume
