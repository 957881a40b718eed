// Where one looks in a picture: depths of what is seen, and places on screen and in the scene.
#include "sandbox/workspace/seen_place.h"

#include <gtest/gtest.h>

#include "sandbox/scene/view.h"

namespace plume {
namespace {

/// A gray fragment that keeps `opacity` of the light; `exact` weights as those before let pass.
PixelProbe pixel(const std::vector<std::pair<float, float>>& depths_and_opacities,
                 std::optional<float> opaque, float emission = 0) {
  PixelProbe probe{.opaque_m = opaque};
  float through = 1;
  for (const auto& [depth, opacity] : depths_and_opacities) {
    probe.fragments.push_back({.depth_m = depth,
                               .emission = glm::vec3(emission),
                               .alpha = opacity,
                               .transmittance = glm::vec3(1 - opacity),
                               .weight = glm::vec3(through)});
    through *= 1 - opacity;
  }
  return probe;
}

TEST(SeenDepth, IsTheSurfaceBehindThinSmokeAndTheMiddleOfThickSmoke) {
  const std::vector<std::pair<float, float>> thin{{2, 0.1f}, {3, 0.1f}},
      thick{{2, 0.2f}, {3, 0.5f}, {4, 0.9f}};
  EXPECT_EQ(seen_depth(pixel(thin, 9))->depth_m, 9);
  EXPECT_FALSE(seen_depth(pixel(thin, 9))->fragment);
  EXPECT_EQ(seen_depth(pixel(thick, 9))->depth_m, 3);
  EXPECT_EQ(seen_depth(pixel(thick, 9))->fragment, 1u);
}

TEST(SeenDepth, OfThinSmokeBeforeTheSkyIsTheSmoke) {
  EXPECT_EQ(seen_depth(pixel({{2, 0.1f}, {3, 0.1f}, {4, 0.1f}}, {}))->depth_m, 3);
  EXPECT_FALSE(seen_depth(pixel({}, {}))) << "the sky alone";
  EXPECT_EQ(seen_depth(pixel({}, 5))->depth_m, 5);
}

TEST(SeenDepth, OfFireThatHidesNothingIsTheFire) {
  EXPECT_EQ(seen_depth(pixel({{2, 0.0f}, {3, 0.0f}}, 9, 40))->depth_m, 3) << "a third each, and the wall";
  EXPECT_EQ(seen_depth(pixel({{2, 0.0f}, {3, 0.0f}}, 9, 0.01f))->depth_m, 9);
}

TEST(PlacesOnScreen, GoToTheSceneAndBack) {
  const auto view =
      make_view({}, {.position = {1, 2, 8}, .target = {0, 1, 0}, .vertical_fov_deg = 40}, {160, 90}, 0);
  const glm::vec2 place{0.2f, 0.7f};
  const glm::vec3 point = point_at(view, place, 5);
  const glm::vec4 clip = view.view_projection * glm::vec4(point, 1);
  EXPECT_NEAR(clip.x / clip.w * 0.5f + 0.5f, place.x, 1e-5f);
  EXPECT_NEAR(clip.y / clip.w * 0.5f + 0.5f, place.y, 1e-5f);
  ASSERT_TRUE(place_of(view, point));
  EXPECT_NEAR(place_of(view, point)->x, place.x, 1e-5f);
  EXPECT_NEAR(place_of(view, point)->y, place.y, 1e-5f);
  EXPECT_FALSE(place_of(view, {1, 2, 20})) << "behind the camera";
}

TEST(PlacesOnScreen, MeetAPlaneOnlyInFrontOfTheCamera) {
  const auto view =
      make_view({}, {.position = {0, 2, 8}, .target = {0, 2, 0}, .vertical_fov_deg = 90}, {100, 100}, 0);
  const auto on_floor = on_plane(view, {0.5f, 0.75f}, {3, 0, 3}, {0, 1, 0});
  ASSERT_TRUE(on_floor);
  EXPECT_NEAR(on_floor->y, 0, 1e-5f);
  EXPECT_NEAR(on_floor->z, 4, 1e-4f) << "2 m down at half the slope of 45 degrees";
  EXPECT_FALSE(on_plane(view, {0.5f, 0.25f}, {0, 0, 0}, {0, 1, 0})) << "above the horizon";
  EXPECT_FALSE(on_plane(view, {0.5f, 0.5f}, {0, 0, 0}, {0, 1, 0})) << "along it";
}

}  // namespace
}  // namespace plume
