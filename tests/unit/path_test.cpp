#include "sandbox/effects/path.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "sandbox/effects/effect.h"

namespace plume {
namespace {

double metres(const Path& path, uint32_t tick) {
  const auto [numerator, denominator] = path.way(tick);
  return static_cast<double>(numerator) / denominator / (1 << Path::kFractionBits);
}

TEST(Path, IsLinearBetweenKeysAndRestsOutsideThem) {
  const Path path({{10, {1, 0, 0}}, {20, {1, 4, 0}}, {22, {1, 4, -3}}});
  EXPECT_EQ(path.at(0), glm::vec3(1, 0, 0));
  EXPECT_EQ(path.at(10), glm::vec3(1, 0, 0));
  EXPECT_EQ(path.at(15), glm::vec3(1, 2, 0));
  EXPECT_EQ(path.at(21), glm::vec3(1, 4, -1.5f));
  EXPECT_EQ(path.at(UINT32_MAX), glm::vec3(1, 4, -3));
}

TEST(Path, TheWayIsTheSumOfItsSegments) {
  const Path path({{10, {1, 0, 0}}, {20, {1, 4, 0}}, {22, {1, 4, -3}}});
  EXPECT_EQ(metres(path, 10), 0.0);
  EXPECT_EQ(metres(path, 15), 2.0);
  EXPECT_EQ(metres(path, 20), 4.0);
  EXPECT_EQ(metres(path, 21), 5.5);
  EXPECT_EQ(metres(path, UINT32_MAX), 7.0);
  EXPECT_EQ(path.length_m(), 7.0);
}

TEST(Path, ThereAndBackIsTwiceTheWay) {
  const Path path({{0, {0, 0, 0}}, {100, {3, 0, 4}}, {200, {0, 0, 0}}});
  EXPECT_EQ(metres(path, 50), 2.5);
  EXPECT_EQ(path.length_m(), 10.0);
}

TEST(Path, SmallStepsOverDaysAreNotLost) {
  // A metre in 20 million ticks: 1/19 of the unit of length each.
  const Path path({{0, {0, 0, 0}}, {kMaxTick, {1, 0, 0}}});
  for (const uint32_t tick : {1u, 19u, 12'345'678u, kMaxTick - 1})
    EXPECT_NEAR(metres(path, tick) * kMaxTick, tick, 1e-6) << tick;
}

TEST(Path, RefusesWhatTheReaderRefuses) {
  const float inf = std::numeric_limits<float>::infinity();
  EXPECT_THROW(Path({}), std::invalid_argument);
  EXPECT_THROW(Path({{0, {0, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(Path({{5, {0, 0, 0}}, {5, {1, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(Path({{5, {0, 0, 0}}, {6, {inf, 0, 0}}}), std::invalid_argument);
  EXPECT_THROW(Path({{5, {0, 0, 0}}, {6, {0, 2e9f, 0}}}), std::invalid_argument);
}

}  // namespace
}  // namespace plume
