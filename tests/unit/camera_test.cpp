#include <gtest/gtest.h>

#include <stdexcept>

#include "sandbox/scene/scene.h"

namespace plume {
namespace {

const std::vector<CameraKey> kKeys = {
    {10, {0, 0, 0}, {0, 0, -1}, 40}, {20, {10, 0, 0}, {0, 4, -1}, 60}, {21, {0, 0, 8}, {0, 0, 0}, 50}};

TEST(Camera, IsLinearBetweenKeys) {
  const CameraKey camera = camera_at(kKeys, 15);
  EXPECT_EQ(camera.tick, 15u);
  EXPECT_EQ(camera.position, glm::vec3(5, 0, 0));
  EXPECT_EQ(camera.target, glm::vec3(0, 2, -1));
  EXPECT_EQ(camera.vertical_fov_deg, 50.0f);
}

TEST(Camera, IsExactlyItsKeyAtTheTickOfTheKey) {
  for (const CameraKey& key : kKeys) {
    EXPECT_EQ(camera_at(kKeys, key.tick).position, key.position);
    EXPECT_EQ(camera_at(kKeys, key.tick).target, key.target);
    EXPECT_EQ(camera_at(kKeys, key.tick).vertical_fov_deg, key.vertical_fov_deg);
  }
}

TEST(Camera, StandsStillBeforeTheFirstAndAfterTheLastKey) {
  EXPECT_EQ(camera_at(kKeys, 0).position, kKeys.front().position);
  EXPECT_EQ(camera_at(kKeys, 1000).position, kKeys.back().position);
  EXPECT_EQ(camera_at(kKeys, 1000).tick, 1000u);
}

TEST(Camera, WithOneKeyNeverMoves) {
  for (const uint32_t tick : {0u, 10u, 99u}) EXPECT_EQ(camera_at({kKeys[0]}, tick).target, kKeys[0].target);
}

TEST(Camera, WithoutKeysIsAnError) {
  EXPECT_THROW(camera_at({}, 0), std::invalid_argument);
}

}  // namespace
}  // namespace plume
