#include "sandbox/window/orbit.h"

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

}  // namespace
}  // namespace plume
