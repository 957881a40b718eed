#include "sandbox/workspace/camera_moves.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

CameraKey camera_at_ten_metres() {
  return {.position = {1, 2, 13}, .target = {1, 2, 3}};
}

float arm_length(const CameraKey& camera) {
  return glm::length(camera.position - camera.target);
}

TEST(OrbitTest, NoMovementLeavesTheCameraWhereItIs) {
  const CameraKey camera = zoom(orbit(camera_at_ten_metres(), {0, 0}), 0);
  EXPECT_NEAR(glm::length(camera.position - glm::vec3(1, 2, 13)), 0, 1e-5);
}

TEST(OrbitTest, PushingTheSceneToTheRightMovesTheCameraToTheLeft) {
  const CameraKey camera = orbit(camera_at_ten_metres(), {90, 0});
  EXPECT_NEAR(glm::length(camera.position - glm::vec3(-9, 2, 3)), 0, 1e-5);
}

TEST(OrbitTest, PushingTheSceneDownRaisesTheCamera) {
  EXPECT_NEAR(orbit(camera_at_ten_metres(), {0, 30}).position.y, 2 + 5, 1e-5);
}

TEST(OrbitTest, KeepsItsDistanceAndTarget) {
  CameraKey camera = camera_at_ten_metres();
  for (int i = 0; i < 1000; ++i) camera = orbit(camera, {7, i % 2 ? 3 : -5});
  EXPECT_NEAR(arm_length(camera), 10, 1e-3);
  EXPECT_EQ(camera.target, glm::vec3(1, 2, 3));
}

TEST(OrbitTest, StopsShortOfStraightUpAndDown) {
  for (const float push : {1000.0f, -1000.0f}) {
    const CameraKey camera = orbit(camera_at_ten_metres(), {0, push});
    EXPECT_GT(glm::length(glm::vec2(camera.position.x - 1, camera.position.z - 3)), 0.1f);
  }
}

TEST(OrbitTest, StraightDownStaysFinite) {
  const CameraKey above{.position = {0, 5, 0}, .target = {0, 0, 0}};
  EXPECT_NEAR(arm_length(orbit(above, {10, 10})), 5, 1e-4);
}

TEST(ZoomTest, UpIsNearerAndDownUndoesIt) {
  const CameraKey near = zoom(camera_at_ten_metres(), 1);
  EXPECT_NEAR(arm_length(near), 9, 1e-5);
  EXPECT_NEAR(arm_length(zoom(near, -1)), 10, 1e-5);
}

TEST(ZoomTest, StopsAtBothEnds) {
  EXPECT_NEAR(arm_length(zoom(camera_at_ten_metres(), 500)), kNearestOrbitM, 1e-5);
  EXPECT_NEAR(arm_length(zoom(camera_at_ten_metres(), -500)), kFarthestOrbitM, 1e-2);
}

TEST(CameraMovesTest, PanKeepsWhatIsAsFarAsTheTargetUnderThePointer) {
  CameraKey camera{.position = {0, 1, 8}, .target = {0, 1, 0}, .vertical_fov_deg = 60};
  const CameraKey moved = pan(camera, {0.5f, 0.25f});
  const float height = 2 * 8 * std::tan(glm::radians(30.0f));
  EXPECT_NEAR(moved.target.x, -0.5f * height, 1e-4f) << "the scene goes right, the camera left";
  EXPECT_NEAR(moved.target.y, 1 + 0.25f * height, 1e-4f) << "the scene goes down, the camera up";
  EXPECT_EQ(moved.position - moved.target, camera.position - camera.target);
}

TEST(CameraMovesTest, LookTurnsTheHeadAndFlyGoesWhereItLooks) {
  const CameraKey camera{.position = {0, 1, 8}, .target = {0, 1, 0}};
  const CameraKey right = look(camera, {90, 0});
  EXPECT_EQ(right.position, camera.position);
  EXPECT_NEAR(right.target.x, 8, 1e-4f);
  EXPECT_NEAR(right.target.z, 8, 1e-4f);
  EXPECT_GT(look(camera, {0, 30}).target.y, 1.0f) << "up";
  EXPECT_LT(look(camera, {0, 120}).target.y, 1.0f + 8.0f) << "not beyond straight up";
  const CameraKey flown = fly(right, {0, 0, 2});
  EXPECT_NEAR(flown.position.x, 2, 1e-4f);
  EXPECT_NEAR(fly(camera, {3, 0, 0}).position.x, 3, 1e-4f) << "to the right";
}

TEST(CameraMovesTest, FocusLooksAtAPlaceUnlessItIsTheEyesOwn) {
  const CameraKey camera{.position = {0, 1, 8}, .target = {0, 1, 0}};
  EXPECT_EQ(focus(camera, {1, 2, 3}).target, glm::vec3(1, 2, 3));
  EXPECT_EQ(focus(camera, {1, 2, 3}).position, camera.position);
  EXPECT_EQ(focus(camera, {0, 1, 8}).target, camera.target);
}

TEST(CameraMovesTest, FrameFillsTheSmallerSideWithoutTurning) {
  const CameraKey camera{.position = {0, 5, 8}, .target = {0, 1, 0}, .vertical_fov_deg = 60};
  const glm::vec3 before = glm::normalize(camera.target - camera.position);
  for (const float aspect : {0.5f, 2.0f}) {
    const CameraKey framed = frame(camera, {3, 2, 1}, 2, aspect);
    EXPECT_EQ(framed.target, glm::vec3(3, 2, 1));
    const glm::vec3 arm = framed.target - framed.position;
    EXPECT_NEAR(glm::dot(glm::normalize(arm), before), 1, 1e-5f);
    const float half_side = std::atan(std::tan(glm::radians(30.0f)) * std::min(aspect, 1.0f));
    EXPECT_NEAR(std::asin(2 / glm::length(arm)), half_side, 0.25f * half_side) << "with a fifth of air";
    EXPECT_LT(std::asin(2 / glm::length(arm)), half_side);
  }
}

}  // namespace
}  // namespace plume
