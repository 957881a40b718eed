// The pictures of a report: each once, smaller where the page would grow too large.
#include <gtest/gtest.h>
#include <unistd.h>
#include <webp/decode.h>

#include "sandbox/measure/image_io.h"
#include "sandbox/report/pictures.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

class ReportPictures : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / ("plume_report_" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    write_noise(1);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Squares of `side` pixels with a colour each.
  void write_noise(int side) const {
    for (const char* name : {"a.png", "b.png"}) {
      DisplayImage noise{640, 64, {}};
      for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 640; ++x) {
          uint32_t state = uint32_t(x / side + 640 * (y / side) + *name * 65536);
          for (int i = 0; i < 4; ++i) state = (state ^ state >> 15) * 0x2c1b3c6du;
          noise.pixels.push_back({uint8_t(state >> 24), uint8_t(state >> 16), uint8_t(state >> 8)});
        }
      write_png(folder_ / name, noise);
    }
  }
  PagePictures taken(uint64_t most_bytes) const {
    return page_pictures(folder_, {"a.png", "gone.png", "b.png"}, most_bytes);
  }
  /// What a browser decodes.
  DisplayImage decoded(const PagePicture& picture) const {
    std::vector<uint8_t> bytes;
    uint32_t word = 0, bits = 0;
    for (const char c : picture.base64) {
      const size_t digit =
          std::string_view("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/").find(c);
      if (digit == std::string_view::npos) break;
      word = word << 6 | uint32_t(digit);
      if ((bits += 6) >= 8) bytes.push_back(uint8_t(word >> (bits -= 8)));
    }
    DisplayImage image;
    if (uint8_t* pixels = WebPDecodeRGB(bytes.data(), bytes.size(), &image.width, &image.height)) {
      for (int i = 0; i < image.width * image.height; ++i)
        image.pixels.push_back({pixels[3 * i], pixels[3 * i + 1], pixels[3 * i + 2]});
      WebPFree(pixels);
      return image;
    }
    write_file(folder_ / "decoded.png", bytes);
    return read_png(folder_ / "decoded.png");
  }

  fs::path folder_;
};

TEST(ReportPictureFiles, OfEveryMomentComeBeforeTheSecondOfAnyAndMapsLast) {
  Results results;
  for (const char* scene : {"a", "b"})
    for (const char* method : {"x", "y"})
      results.frames.push_back({.scene = scene,
                                .method = method,
                                .image = std::string(scene) + method,
                                .error_map = std::string(method) == "x" ? "" : std::string(scene) + "!"});
  EXPECT_EQ(picture_files(results), (std::vector<std::string>{"ax", "bx", "ay", "by", "a!", "b!"}));
}

TEST_F(ReportPictures, AreTheFilesThemselvesWhereThereIsRoom) {
  const PagePictures pictures = taken(1 << 20);
  ASSERT_EQ(pictures.all.size(), 2u) << "one that is gone is left out";
  EXPECT_EQ(pictures.all[1].file, "b.png");
  EXPECT_EQ(pictures.divisor, 1);
  EXPECT_EQ(pictures.left_out, 0u);
  EXPECT_EQ(decoded(pictures.all[1]).pixels, read_png(folder_ / "b.png").pixels);
}

TEST_F(ReportPictures, AreHalvedUntilTheyFit) {
  const uint64_t whole = taken(1 << 20).bytes();
  const PagePictures pictures = taken(whole / 2);
  EXPECT_EQ(pictures.divisor, 2);
  EXPECT_EQ(pictures.left_out, 0u);
  EXPECT_LE(pictures.bytes(), whole / 2);
  const DisplayImage half = decoded(pictures.all[0]);
  EXPECT_EQ(half.width, 320);
  EXPECT_EQ(half.height, 32);
}

TEST_F(ReportPictures, AreHalvedAgainWhereThatSavesLittle) {
  write_noise(4);  // halved, it has as many colours as before
  const uint64_t whole = taken(1 << 20).bytes(), half = taken(whole - 1).bytes();
  ASSERT_LT(half, whole);
  ASSERT_GT(half, whole / 3);
  const PagePictures pictures = taken(half - 1);
  EXPECT_EQ(pictures.divisor, 4);
  EXPECT_EQ(pictures.left_out, 0u);
  EXPECT_LT(pictures.bytes(), half);
}

TEST_F(ReportPictures, AreLeftOutRatherThanMadeTooSmallToSee) {
  const uint64_t half = taken(taken(1 << 20).bytes() - 1).bytes();
  const PagePictures quarter = taken(half - 1);
  ASSERT_EQ(quarter.divisor, 4);
  const PagePictures pictures = taken(quarter.all[0].base64.size());
  EXPECT_EQ(pictures.divisor, 4);
  EXPECT_EQ(pictures.left_out, 1u);
  EXPECT_FALSE(pictures.all[0].base64.empty());
  EXPECT_TRUE(pictures.all[1].base64.empty());
  EXPECT_EQ(taken(0).left_out, 2u);
}

}  // namespace
}  // namespace plume
