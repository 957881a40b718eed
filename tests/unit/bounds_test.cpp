// Bounds where the answer is known in closed form; tests/gpu/bounds_test.cpp holds them to particles.
#include "sandbox/effects/bounds.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plume {
namespace {

constexpr double kTick = 1.0 / 60.0;

/// A point that emits particles of radius 0.5 m and a life of 61 ticks: 60 steps.
Effect effect_of(const Motion& motion) {
  Emitter emitter{.name = "e",
                  .spawn = {.bursts = {{0, 1}}, .life_ticks = {1, 61}},
                  .motion = motion,
                  .look = {.radius_m = 0.5f, .opacity = 1.0f}};
  return {.id = "test", .emitters = {emitter}};
}

constexpr float kCard = 0.70711f;  // half the diagonal of a card: it may turn

void expect_box(const Bounds& bounds, glm::vec3 min, glm::vec3 max) {
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(bounds.min[c], min[c], 1e-3) << "axis " << c;
    EXPECT_NEAR(bounds.max[c], max[c], 1e-3) << "axis " << c;
  }
}

TEST(Bounds, OfAParticleAtRestAreItsCard) {
  const Bounds bounds = effect_bounds(effect_of({}), {.position = {1, 2, 3}});
  expect_box(bounds, glm::vec3(1, 2, 3) - kCard, glm::vec3(1, 2, 3) + kCard);
}

TEST(Bounds, NothingHasNoBounds) {
  EXPECT_TRUE(effect_bounds({}, {}).empty());
  EXPECT_EQ(effect_bounds({}, {}).volume(), 0.0);
  EXPECT_FALSE(Bounds().contains({0, 0, 0}));
}

TEST(Bounds, FollowAThrowExactly) {
  const Bounds bounds = effect_bounds(effect_of({.velocity = {3, 4, 0}, .gravity = 1}), {});
  double y = 0, v = 4, low = 0, high = 0;
  for (int i = 0; i < 60; ++i)
    y += (v -= 9.81 * kTick) * kTick, low = std::min(low, y), high = std::max(high, y);
  expect_box(bounds, {-kCard, low - kCard, -kCard}, {3 + kCard, high + kCard, kCard});
}

TEST(Bounds, DragPullsToTheWind) {
  const Bounds bounds = effect_bounds(effect_of({.drag = 1e3f, .wind = 0.5f}), {.wind = {4, 0, -2}});
  const double way = (60 - 1 / 16.667) * kTick;  // the first step slips by 1 / (1 + drag dt)
  expect_box(bounds, {-kCard, -kCard, -way - kCard}, {2 * way + kCard, kCard, kCard});
}

TEST(Bounds, BuoyancyCools) {
  const Bounds bounds = effect_bounds(effect_of({.buoyancy = 2, .cooling_s = 0.25f}), {});
  double y = 0, v = 0;
  for (int i = 0; i < 60; ++i) y += (v += 2 * std::exp(-i * kTick / 0.25) * kTick) * kTick;
  expect_box(bounds, glm::vec3(-kCard), {kCard, y + kCard, kCard});
}

TEST(Bounds, EndAtTheFloor) {
  const Bounds bounds = effect_bounds(effect_of({.gravity = 1, .floor_y = -0.25f}), {});
  expect_box(bounds, {-kCard, -0.25f - kCard, -kCard}, glm::vec3(kCard));
  // Below it from birth: a floor lifts.
  expect_box(effect_bounds(effect_of({.floor_y = 2}), {}), glm::vec3(-kCard), {kCard, 2 + kCard, kCard});
}

TEST(Bounds, TurnWithTheInstance) {
  Effect effect = effect_of({.velocity = {3, 0, 0}});
  effect.emitters[0].shape = {.kind = ShapeKind::kBox, .size_m = {2, 0, 4}, .offset_m = {5, 0, 0}};
  const Bounds bounds = effect_bounds(effect, {.yaw_deg = 90});  // +x becomes -z
  expect_box(bounds, {-2 - kCard, -kCard, -5 - 1 - 3 - kCard}, {2 + kCard, kCard, -5 + 1 + kCard});
}

TEST(Bounds, TakeInLinesAndMeshes) {
  Effect effect = effect_of({.speed = {1, 1}});
  Shape& shape = effect.emitters[0].shape;
  shape = {.kind = ShapeKind::kLine, .to_m = {0, 6, 0}};  // throws across itself
  expect_box(effect_bounds(effect, {}), {-1 - kCard, -kCard, -1 - kCard}, {1 + kCard, 6 + kCard, 1 + kCard});
  shape = {.kind = ShapeKind::kMesh, .mesh = {.id = "m"}, .scale = 2};
  effect.meshes = {{.id = "m", .triangles = {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 3}}}}}};
  expect_box(effect_bounds(effect, {.yaw_deg = 180}), {-2 - 1 - kCard, -1 - kCard, -6 - 1 - kCard},
             {1 + kCard, 2 + 1 + kCard, 1 + kCard});
}

TEST(Bounds, GoAlongThePath) {
  const Path path({{0, {0, 0, 0}}, {10, {10, 0, 0}}, {20, {10, 0, -7}}});
  const Bounds bounds = effect_bounds(effect_of({}), {.position = {100, 0, 0}, .path = &path});
  expect_box(bounds, {100 - kCard, -kCard, -7 - kCard}, {110 + kCard, kCard, kCard});
}

TEST(Bounds, CountTheLargestCardAndItsStretch) {
  Effect effect = effect_of({.velocity = {0, 8, 0}});
  effect.emitters[0].spawn.life_ticks = {1, 1};  // drawn at age 0 only
  effect.emitters[0].look.stretch_s = 0.25f;
  effect.emitters[0].look.radius_scale = {1, 3};
  const float card = std::hypot(1.5f, 1.5f + 2.0f);
  expect_box(effect_bounds(effect, {}), glm::vec3(-card), glm::vec3(card));
}

TEST(Bounds, ASphereThrowsToAllSidesAndAHemisphereUp) {
  for (const ShapeKind kind : {ShapeKind::kSphere, ShapeKind::kHemisphere}) {
    Effect effect = effect_of({.speed = {1, 6}});
    effect.emitters[0].shape = {.kind = kind, .radius_m = 2};
    const float low = kind == ShapeKind::kSphere ? -8 - kCard : -kCard;
    expect_box(effect_bounds(effect, {}), {-8 - kCard, low, -8 - kCard}, glm::vec3(8 + kCard));
  }
}

}  // namespace
}  // namespace plume
