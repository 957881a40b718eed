#include "sandbox/workspace/key_edits.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

constexpr Limits kShare{0, 1};

TEST(KeyEdits, AMovedKeyStaysBetweenItsNeighboursAndInItsLimits) {
  Curve curve({{0.0f, 0.2f}, {0.5f, 0.4f}, {1.0f, 0.6f}});
  move_key(curve, 1, 0.75f, 0.9f, kShare);
  EXPECT_EQ(curve.keys[1], (Curve::Key{0.75f, 0.9f}));
  move_key(curve, 1, 3.0f, 7.0f, kShare);
  EXPECT_EQ(curve.keys[1], (Curve::Key{1.0f - kKeyDistance, 1.0f}));
  move_key(curve, 1, -3.0f, -7.0f, kShare);
  EXPECT_EQ(curve.keys[1], (Curve::Key{kKeyDistance, 0.0f}));
  move_key(curve, 0, 0.9f, 0.5f, kShare);
  EXPECT_EQ(curve.keys[0].at, 0.0f) << "there is no room before its neighbour";
  move_key(curve, 2, 0.3f, 0.5f, kShare);
  EXPECT_EQ(curve.keys[2].at, 0.3f);
  move_key(curve, 2, 2.0f, 0.5f, kShare);
  EXPECT_EQ(curve.keys[2].at, 1.0f);
}

TEST(KeyEdits, ANewKeyFindsItsPlaceAndTheLastOneStays) {
  Curve curve(0.5f);
  EXPECT_EQ(add_key(curve, 0.8f, 0.7f), 1u);
  EXPECT_EQ(add_key(curve, 0.4f, 0.1f), 1u);
  EXPECT_EQ(add_key(curve, 0.4f, 0.3f), std::nullopt) << "there is one";
  EXPECT_EQ(add_key(curve, 0.8005f, 0.3f), std::nullopt) << "too near";
  EXPECT_EQ(add_key(curve, 1.01f, 0.3f), std::nullopt);
  EXPECT_EQ(curve, Curve({{0.0f, 0.5f}, {0.4f, 0.1f}, {0.8f, 0.7f}}));
  remove_key(curve, 1);
  EXPECT_EQ(curve, Curve({{0.0f, 0.5f}, {0.8f, 0.7f}}));
  remove_key(curve, 1);
  remove_key(curve, 0);
  EXPECT_EQ(curve, Curve(0.5f));
}

TEST(KeyEdits, AGradientsNewKeyHasTheColorThatWasThere) {
  Gradient gradient({{0.0f, glm::vec3(0)}, {1.0f, glm::vec3(2, 4, 8)}});
  ASSERT_EQ(add_key(gradient, 0.25f), 1u);
  EXPECT_EQ(gradient.keys[1].value, glm::vec3(0.5f, 1, 2));
  move_key(gradient, 1, 1.5f);
  EXPECT_EQ(gradient.keys[1].at, 1.0f - kKeyDistance);
  remove_key(gradient, 1);
  EXPECT_EQ(gradient.keys.size(), 2u);
}

TEST(KeyEdits, NumbersAreAsShortAsAPixelIsCoarse) {
  EXPECT_EQ(rounded(0.123456, 0.004), 0.123f);
  EXPECT_EQ(rounded(0.7, 0.01), 0.7f);
  EXPECT_EQ(rounded(-12.3456, 0.3), -12.3f);
  EXPECT_EQ(rounded(1234.5, 30), 1230.0f);
  EXPECT_EQ(rounded(7.6, 1), 8.0f);
}

TEST(KeyEdits, TheAxisShowsAllOfACurve) {
  for (const Curve& curve :
       {Curve(0.5f), Curve(0.0f), Curve(-3.0f), Curve({{0.0f, 2.0f}, {1.0f, 2.1f}}),
        Curve({{0.0f, 0.0f, {}, 9.0f}, {1.0f, 0.0f}}), Curve({{0.2f, -1.0f}, {0.4f, 5.0f}})}) {
    const auto [least, largest] = curve.extremes();
    const Axis axis = axis_of(curve);
    EXPECT_LT(axis.low, least.value);
    EXPECT_GT(axis.high, largest.value);
  }
  EXPECT_LE(axis_of(Curve({{0.0f, 0.1f}, {1.0f, 0.5f}})).low, 0.0);
}

}  // namespace
}  // namespace plume
