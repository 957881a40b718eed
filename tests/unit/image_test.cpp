#include "sandbox/measure/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace plume {
namespace {

TEST(ImageTest, PixelsAreAddressedByColumnAndRow) {
  Image image{3, 2, std::vector<glm::vec3>(6)};
  image.at(2, 1) = {1.0f, 2.0f, 3.0f};
  EXPECT_EQ(image.pixels[5], glm::vec3(1.0f, 2.0f, 3.0f));
}

TEST(ImageTest, PixelsOutsideThePictureThrow) {
  Image image{3, 2, std::vector<glm::vec3>(6)};
  EXPECT_THROW(image.at(3, 0), std::out_of_range);
  EXPECT_THROW(image.at(-1, 1), std::out_of_range);
  EXPECT_THROW(image.at(0, 2), std::out_of_range);
}

TEST(ImageTest, SrgbMatchesTheStandardAtKnownValues) {
  EXPECT_FLOAT_EQ(srgb_from_linear(0.0f), 0.0f);
  EXPECT_FLOAT_EQ(srgb_from_linear(1.0f), 1.0f);
  EXPECT_FLOAT_EQ(srgb_from_linear(0.001f), 0.01292f);                // the linear toe
  EXPECT_NEAR(srgb_from_linear(0.18f), 0.46135613, 1e-6);             // middle grey
  EXPECT_NEAR(linear_from_srgb(0.5f), 0.21404114, 1e-6);              // and the way back
  EXPECT_NEAR(linear_from_srgb(0.04f), 0.04 / 12.92, 1e-9);           // below the joint
  EXPECT_NEAR(linear_from_srgb(0.041f), 0.00317428, 1e-7);            // above it
  EXPECT_NEAR(srgb_from_linear(linear_from_srgb(0.7f)), 0.7f, 1e-6);  // inverse
}

TEST(ImageTest, DisplayValuesSurviveLinearLight) {
  DisplayImage all{256, 1, {}};
  for (int i = 0; i < 256; ++i)
    all.pixels.push_back(
        {static_cast<uint8_t>(i), static_cast<uint8_t>(255 - i), static_cast<uint8_t>(i / 2)});
  EXPECT_EQ(to_display(to_linear(all)).pixels, all.pixels);
}

TEST(ImageTest, ADisplaySaturatesOutsideItsRange) {
  const Image image{1, 1, {{-3.0f, 7.0f, std::numeric_limits<float>::infinity()}}};
  EXPECT_EQ(to_display(image).pixels[0], (std::array<uint8_t, 3>{0, 255, 255}));
}

TEST(ImageTest, ANanShowsAsMagenta) {
  const Image image{1, 1, {{0.5f, std::nanf(""), 0.5f}}};
  EXPECT_EQ(to_display(image).pixels[0], (std::array<uint8_t, 3>{255, 0, 255}));
}

}  // namespace
}  // namespace plume
