#include "sandbox/effects/motion_tables.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

Emitter colliding(float radius_m) {
  Emitter emitter;
  emitter.motion.collision = Collision{.radius_m = radius_m};
  return emitter;
}

TEST(MotionTables, AnEmitterLooksOnlyAtSolidsItsParticlesCanReach) {
  const std::vector<Solid> solids{
      {.kind = SolidKind::kPlane, .position = {0, 0, 0}, .size_m = {50, 0, 50}},
      {.kind = SolidKind::kBox, .position = {6, 1, 0}, .size_m = {1, 2, 8}},                 // from x = 5.5
      {.kind = SolidKind::kBox, .position = {6, 1, 0}, .size_m = {1, 2, 8}, .yaw_deg = 90},  // from x = 2
      {.kind = SolidKind::kSphere, .position = {0, 9, 0}, .radius_m = 2},                    // from y = 7
      {.kind = SolidKind::kCapsule,
       .position = {0, 1, 9},
       .end = {0, 1, 4},
       .radius_m = 0.5f}  // from z = 3.5
  };
  MotionTables tables(solids);
  const auto counts = [&](const Emitter& emitter, const std::optional<Bounds>& reach) {
    shared::EmitterData data{};
    tables.fill(emitter, data, reach ? &*reach : nullptr);
    return std::pair(data.box_count, data.round_count);
  };
  using Counts = std::pair<uint32_t, uint32_t>;
  const Emitter small = colliding(0), large = colliding(1), none;
  EXPECT_EQ(Counts(3, 2), counts(small, {})) << "everywhere";
  EXPECT_EQ(Counts(2, 0), counts(small, Bounds{{-3, -1, -3}, {3, 3, 3}}));
  EXPECT_EQ(Counts(2, 1), counts(large, Bounds{{-3, -1, -3}, {3, 3, 3}}))
      << "the capsule, with a body of 1 m";
  EXPECT_EQ(Counts(1, 0), counts(small, Bounds{{-3, -99, -3}, {1, -90, 3}})) << "the ground is deep";
  EXPECT_EQ(Counts(0, 1), counts(small, Bounds{{-3, 6, -3}, {3, 8, 3}}));
  EXPECT_EQ(Counts(0, 0), counts(none, {})) << "it does not collide";
}

TEST(MotionTables, InstancesShareEntriesAndEqualListsAreKeptOnce) {
  MotionTables tables({{.kind = SolidKind::kSphere}, {.kind = SolidKind::kSphere, .position = {9, 0, 0}}});
  Emitter a = colliding(0), b = colliding(0);
  a.motion.attractors = {{.strength = 1}, {.strength = 2}};
  b.motion.attractors = {{.strength = 3}};
  shared::EmitterData first{}, again{}, other{}, one{};
  tables.fill(a, first);
  tables.fill(b, other);
  tables.fill(a, again);
  const Bounds near{{-1, -1, -1}, {1, 1, 1}};
  tables.fill(a, one, &near);
  EXPECT_EQ(first.attractor_first, again.attractor_first);
  EXPECT_EQ(2u, other.attractor_first);
  EXPECT_EQ(first.round_first, other.round_first);
  EXPECT_EQ(2u, first.round_count);
  EXPECT_EQ(1u, one.round_count);
  EXPECT_EQ(2u, one.round_first);
}

TEST(MotionTables, FeaturesNameWhatAnEmitterUses) {
  Emitter emitter;
  EXPECT_EQ(0u, features_of(emitter));
  emitter.motion.vortex.pull = 1;
  emitter.motion.orbit = -1;
  EXPECT_EQ(shared::kUsesVortex | shared::kUsesOrbit, features_of(emitter));
  emitter.motion = {};
  emitter.motion.curl.strength = 1;
  emitter.motion.kill.emplace_back();
  emitter.motion.collision.emplace();
  EXPECT_EQ(shared::kUsesCurl | shared::kUsesKill | shared::kUsesCollision, features_of(emitter));
}

}  // namespace
}  // namespace plume
