#include "sandbox/effects/view_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sandbox/scene/view.h"

namespace plume {
namespace {

class ViewVolumeTest : public testing::Test {
 protected:
  float between(float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); }
  glm::vec3 anywhere(float size) {
    return {between(-size, size), between(-size, size), between(-size, size)};
  }

  std::mt19937 random{3};
  Scene scene;
};

TEST_F(ViewVolumeTest, NothingThatIsInThePictureIsMissed) {
  int seen = 0, hidden = 0;
  for (int i = 0; i < 20'000; ++i) {
    const CameraKey camera{
        .position = anywhere(50), .target = anywhere(50), .vertical_fov_deg = between(5, 120)};
    const shared::ViewData view = make_view(scene, camera, {1u + random() % 400, 1u + random() % 400}, 0);
    const float size = std::pow(10.0f, between(-2, 2));
    const glm::vec3 a = anywhere(60), b = a + glm::abs(anywhere(size));
    const bool touches = may_touch(view_volume(view), {a, b});
    (touches ? seen : hidden)++;
    for (int j = 0; j < 20 && !touches; ++j) {
      const glm::vec3 point = glm::mix(a, b, glm::vec3(between(0, 1), between(0, 1), between(0, 1)));
      const glm::vec4 clip = view.view_projection * glm::vec4(point, 1);
      ASSERT_FALSE(clip.w > view.near_m && std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w)
          << "box " << i;
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 1000);
}

TEST_F(ViewVolumeTest, WhatIsBesideOrBehindIsNotTouched) {
  const CameraKey camera{.position = {0, 2, 10}, .target = {0, 2, 0}};
  const ViewVolume volume = view_volume(make_view(scene, camera, {640, 360}, 0));
  const auto touched = [&](glm::vec3 middle, float radius) {
    return may_touch(volume, {middle - radius, middle + radius});
  };
  EXPECT_TRUE(touched({0, 2, 0}, 1));
  EXPECT_TRUE(touched({0, 2, 10}, 1));      // the camera is in it
  EXPECT_TRUE(touched({0, 2, -5000}, 1));   // there is no far end
  EXPECT_FALSE(touched({0, 2, 12}, 1));     // behind
  EXPECT_FALSE(touched({0, 2, 500}, 480));  // large, behind
  EXPECT_FALSE(touched({-30, 2, 0}, 5));
  EXPECT_FALSE(touched({30, 2, 0}, 5));
  EXPECT_FALSE(touched({0, 20, 0}, 5));
  EXPECT_FALSE(touched({0, -20, 0}, 5));
  EXPECT_FALSE(may_touch(volume, {}));
}

TEST_F(ViewVolumeTest, WideningTakesInWhatIsJustBesideThePicture) {
  const CameraKey camera{.position = {0, 0, 0}, .target = {0, 0, -1}, .vertical_fov_deg = 90};
  const shared::ViewData view = make_view(scene, camera, {100, 100}, 0);
  const Bounds beside{{10.5f, 0, -10}, {10.6f, 1, -9.9f}};
  EXPECT_FALSE(may_touch(view_volume(view), beside));
  EXPECT_TRUE(may_touch(view_volume(view, 1.1f), beside));
}

}  // namespace
}  // namespace plume
