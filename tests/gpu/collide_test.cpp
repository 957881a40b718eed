// Particles among the scene's solids: bounce, slide, die and stick against closed forms; nothing gets in or
// through.
#include <fmt/format.h>

#include <algorithm>
#include <random>

#include "sandbox/scene/figure.h"
#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

using enum CollisionResponse;

class CollideTest : public MovingParticles {
 protected:
  static Solid ground(float y = 0) {
    return {.kind = SolidKind::kPlane, .position = {0, y, 0}, .size_m = {200, 0, 200}};
  }
  static Emitter falling(const Collision& collision, uint32_t count = 1) {
    Emitter e = emitter(count);
    e.motion.gravity = 1;
    e.motion.collision = collision;
    return e;
  }
  /// Metres from the surface, negative inside. In double, from the definition of each solid.
  static double distance_to(const Solid& solid, glm::dvec3 place) {
    const glm::dvec3 arm = place - glm::dvec3(solid.position);
    if (solid.kind == SolidKind::kSphere) return glm::length(arm) - double(solid.radius_m);
    if (solid.kind == SolidKind::kCapsule) {
      const glm::dvec3 core = glm::dvec3(solid.end) - glm::dvec3(solid.position);
      const double t = std::clamp(glm::dot(arm, core) / glm::dot(core, core), 0.0, 1.0);
      return glm::length(arm - core * t) - double(solid.radius_m);
    }
    const double yaw = solid.kind == SolidKind::kBox ? glm::radians(double(solid.yaw_deg)) : 0.0;
    const double s = std::sin(yaw), c = std::cos(yaw);
    const glm::dvec3 local(arm.x * c - arm.z * s, arm.y, arm.z * c + arm.x * s);
    const glm::dvec3 half = glm::dvec3(solid.size_m) * 0.5;
    glm::dvec3 q = glm::abs(local) - half;
    if (solid.kind == SolidKind::kPlane) q.y = local.y;  // as deep as one likes
    return glm::length(glm::max(q, 0.0)) + std::min(std::max({q.x, q.y, q.z}), 0.0);
  }
};

TEST_F(CollideTest, ABounceGivesBackTheSquareOfTheRestitutionInHeight) {
  Emitter e = falling({.bounce = 0.6f});
  const Place place{.origin = {0, 2, 0}, .solids = {ground()}};
  std::vector<double> peaks;
  const auto states = track(e, 240, place);
  for (size_t i = 1; i + 1 < states.size(); ++i)
    if (states[i].velocity.y > 0 && states[i + 1].velocity.y <= 0)
      peaks.push_back(double(states[i].position.y));
  ASSERT_GE(peaks.size(), 2u);
  EXPECT_NEAR(2 * 0.36, peaks[0], 0.003) << "a tick's resolution of the top of the parabola";
  EXPECT_NEAR(2 * 0.36 * 0.36, peaks[1], 0.003);
}

TEST_F(CollideTest, ABallThatBouncesWithoutLossKeepsItsEnergy) {
  Emitter e = falling({.bounce = 1, .friction = 0});
  e.motion.velocity = {0.3f, 0, 0};
  const auto states = track(e, 600, {.origin = {0, 2, 0}, .solids = {ground()}});
  const double g = 9.81, half_tick = 0.5 * g * kTickSeconds;
  for (const auto& p : states) {  // what symplectic Euler conserves: v is half a tick ahead
    const double v = double(p.velocity.y) - half_tick;
    EXPECT_NEAR(2 * g + half_tick * half_tick / 2, g * double(p.position.y) + v * v / 2, 0.01);
    EXPECT_FLOAT_EQ(0.3f, p.velocity.x);
  }
  EXPECT_GT(collisions_of(states.back()), 5u);
}

TEST_F(CollideTest, FrictionStopsASlidingParticleAfterItsStoppingDistanceAndThereItRests) {
  Emitter e = falling({.response = kSlide, .friction = 0.4f, .radius_m = 0.1f});
  e.motion.velocity = {3, 0, 0};
  const auto states = track(e, 150, {.origin = {0, 0.1f, 0}, .solids = {ground()}});
  EXPECT_NEAR(3.0 * 3.0 / (2 * 0.4 * 9.81), double(states.back().position.x), 0.03) << "half a tick at 3 m/s";
  EXPECT_EQ(glm::vec3(0), states.back().velocity);
  EXPECT_NEAR(0.1f, states.back().position.y, 1e-4f);
  for (size_t i = 120; i < states.size(); ++i)
    EXPECT_EQ(states.back().position, states[i].position) << "jitters";
}

TEST_F(CollideTest, WithoutFrictionASlideKeepsTheTangentialSpeedAlongATurnedWall) {
  Solid wall{.kind = SolidKind::kBox, .position = {2, 0, 0}, .size_m = {1, 10, 60}, .yaw_deg = 30};
  Emitter e = emitter(1);
  e.motion.velocity = {4, 0, 0};
  e.motion.collision = Collision{.response = kSlide};
  const auto end = track(e, 120, {.solids = {wall}}).back();
  const double angle = glm::radians(30.0);  // along the wall: z turned
  const glm::dvec3 along(std::sin(angle), 0, std::cos(angle));
  EXPECT_LT(glm::length(glm::dvec3(end.velocity) - along * (4 * std::sin(angle))), 1e-4);
  EXPECT_NEAR(0.0, distance_to(wall, glm::dvec3(end.position)), 1e-4);
}

TEST_F(CollideTest, WhatSticksStaysWhereItTouchedAndWhatDiesIsGone) {
  const Solid ball{.kind = SolidKind::kSphere, .position = {0, -2, 0}, .radius_m = 1};
  Emitter e = falling({.response = kStick, .radius_m = 0.05f}, 300);
  e.shape = {.kind = ShapeKind::kBox, .size_m = {2, 0, 2}};
  const Place place{.solids = {ball}};
  size_t stuck = 0;
  const auto at_100 = particles_at(e, 100, place), at_200 = particles_at(e, 200, place);
  for (size_t i = 0; i < at_100.size(); ++i) {
    if (!(contact_of(at_100[i]) & shared::kStuck)) continue;
    ++stuck;
    EXPECT_NEAR(0.05, distance_to(ball, glm::dvec3(at_100[i].position)), 1e-4);
    EXPECT_GT(at_100[i].position.y, ball.position.y) << "on the far side";
    EXPECT_EQ(at_100[i].position, at_200[i].position);
    EXPECT_EQ(glm::vec3(0), at_200[i].velocity);
    EXPECT_EQ(1u, collisions_of(at_200[i]));
  }
  EXPECT_GT(stuck, 200u);
  e.motion.collision->response = kDie;
  const auto dead = particles_at(e, 200, place);
  EXPECT_EQ(stuck, size_t(std::ranges::count_if(dead, is_dead)));
}

TEST_F(CollideTest, NothingTunnelsThroughAThinPostAtAHundredMetresASecond) {
  for (const Solid& post :
       {Solid{.kind = SolidKind::kCapsule, .position = {5, -3, 0}, .end = {5, 3, 0}, .radius_m = 0.025f},
        Solid{.kind = SolidKind::kBox, .position = {5, 0, 0}, .size_m = {0.05f, 6, 0.05f}}}) {
    Emitter e = emitter(2000);
    e.shape = {.kind = ShapeKind::kBox, .size_m = {2, 4, 0.2f}};
    e.motion.velocity = {100, 0, 0};
    e.motion.collision = Collision{.response = kStick};
    const auto born = particles_at(e, 0, {.solids = {post}}), ended = particles_at(e, 30, {.solids = {post}});
    size_t hits = 0;
    for (size_t i = 0; i < born.size(); ++i) {
      const double aside = std::abs(double(born[i].position.z)) - 0.025;
      if (std::abs(aside) < 1e-5) continue;
      hits += aside < 0;
      EXPECT_EQ(aside < 0, (contact_of(ended[i]) & shared::kStuck) != 0);
      if (aside < 0)
        EXPECT_NEAR(0.0, distance_to(post, glm::dvec3(ended[i].position)), 1e-4);
      else
        EXPECT_GT(ended[i].position.x, 45.0f);
    }
    EXPECT_GT(hits, 300u);
  }
}

TEST_F(CollideTest, WhatIsBornInsideASolidComesOutOnTheNearestSide) {
  const std::vector<Solid> solids{
      {.kind = SolidKind::kSphere, .position = {0, 0, 0}, .radius_m = 1},
      {.kind = SolidKind::kBox, .position = {0, 0, 0}, .size_m = {1, 2, 3}, .yaw_deg = 25},
      {.kind = SolidKind::kCapsule, .position = {-1, 0, 0}, .end = {1, 0.5f, 0}, .radius_m = 0.7f},
      ground(0.3f)};
  for (const Solid& solid : solids) {
    Emitter e = emitter(300);
    e.shape = {.kind = ShapeKind::kSphere, .radius_m = 0.8f};
    e.motion.collision = Collision{.response = kSlide, .radius_m = 0.02f};
    const auto born = particles_at(e, 0, {.solids = {solid}}), out = particles_at(e, 1, {.solids = {solid}});
    size_t pushed = 0;
    for (size_t i = 0; i < born.size(); ++i) {
      const double before = distance_to(solid, glm::dvec3(born[i].position)) - 0.02;
      const double moved = double(glm::length(out[i].position - born[i].position));
      pushed += before < 0;
      EXPECT_GT(distance_to(solid, glm::dvec3(out[i].position)), 0.0199);
      EXPECT_NEAR(std::max(-before, 0.0), moved, 1e-4) << "not the nearest way";
    }
    EXPECT_GT(pushed, 50u);
  }
  Emitter centre = emitter(1);
  centre.motion.collision = Collision{.response = kSlide};
  for (size_t i = 0; i < 3; ++i)
    EXPECT_GT(
        distance_to(solids[i], glm::dvec3(particles_at(centre, 1, {.solids = {solids[i]}})[0].position)),
        -1e-4);
}

TEST_F(CollideTest, ParticlesOnABoxStayThereForGood) {
  const Solid box{.kind = SolidKind::kBox, .position = {0, 0.5f, 0}, .size_m = {2, 1, 2}, .yaw_deg = 20};
  Emitter e = falling({.bounce = 0.3f, .friction = 0.5f, .radius_m = 0.03f}, 100);
  e.shape = {.kind = ShapeKind::kBox, .size_m = {1, 0.5f, 1}};
  const Place place{.origin = {0, 2, 0}, .solids = {ground(), box}};
  const auto settled = particles_at(e, 200, place), later = particles_at(e, 600, place);
  for (size_t i = 0; i < settled.size(); ++i) {
    EXPECT_EQ(settled[i].position, later[i].position);
    EXPECT_EQ(glm::vec3(0), later[i].velocity);
    EXPECT_NEAR(1.03f, later[i].position.y, 1e-4f);
  }
}

TEST_F(CollideTest, OnlyImpactsAboveTheEventSpeedCountAndTheCountSaturates) {
  const Place place{.origin = {0, 0.5f, 0},
                    .solids = {ground()}};  // impacts at 3.1 m/s, and 0.6 times that, ...
  EXPECT_EQ(1u, collisions_of(particles_at(falling({.bounce = 0.6f, .event_speed = 2.5f}), 300, place)[0]));
  EXPECT_EQ(2u, collisions_of(particles_at(falling({.bounce = 0.6f, .event_speed = 1.5f}), 300, place)[0]));
  EXPECT_EQ(0u, collisions_of(particles_at(falling({.bounce = 0.6f, .event_speed = 4}), 300, place)[0]));
  EXPECT_EQ(15u, collisions_of(particles_at(falling({.bounce = 1, .event_speed = 0.5f}), 1500, place)[0]));
}

TEST_F(CollideTest, NothingGetsIntoAnySolidOfACrowdedSceneAlsoFarFromTheOrigin) {
  for (const glm::vec3 origin : {glm::vec3(0), glm::vec3(3000, 500, -2000)}) {
    std::vector<Solid> solids{ground(-1)};
    for (const Solid& part : standing_figure({0.5f, -1, 0.5f}, 40, 1.8f, glm::vec3(0.5f), Material::kUnlit))
      solids.push_back(part);
    solids.push_back(
        {.kind = SolidKind::kBox, .position = {-1, -0.5f, 0}, .size_m = {1, 1, 2}, .yaw_deg = 33});
    solids.push_back(
        {.kind = SolidKind::kBox, .position = {-1.5f, 0, 0.4f}, .size_m = {0.3f, 3, 0.3f}, .yaw_deg = -12});
    solids.push_back({.kind = SolidKind::kSphere, .position = {0, -0.8f, -1}, .radius_m = 0.6f});
    solids.push_back({.kind = SolidKind::kCapsule,
                      .position = {-2, -0.9f, -2},
                      .end = {2, -0.2f, -1.5f},
                      .radius_m = 0.2f});
    std::vector<Emitter> emitters;
    for (const CollisionResponse response : {kBounce, kSlide}) {
      Emitter e = falling({.response = response, .bounce = 0.5f, .friction = 0.2f, .radius_m = 0.01f}, 600);
      e.name = response == kBounce ? "bounce" : "slide";
      e.shape = {.kind = ShapeKind::kBox, .size_m = {4, 0.2f, 4}, .offset_m = {0, 3, 0}};
      e.motion.velocity = {1, -20, 0.5f};
      e.motion.curl = {.strength = 20};
      emitters.push_back(e);
    }
    for (Solid& solid : solids) solid.position += origin, solid.end += origin;
    const Effect effect = effect_of(emitters);
    Simulation simulation = simulate(effect, {.origin = origin, .solids = solids});
    simulation.seek(0);
    double deepest = 1;
    std::string where;
    const auto check = [&] {
      for (const auto& p : simulation.particles())
        for (const Solid& solid : solids)
          if (const double distance = distance_to(solid, glm::dvec3(p.position)); distance < deepest) {
            deepest = distance;
            where = fmt::format("birth {} (state {:x}) at ({}, {}, {}), solid {} at tick {}", p.birth,
                                p.state, p.position.x, p.position.y, p.position.z, &solid - solids.data(),
                                simulation.tick());
          }
    };
    for (int i = 0; i < 100; ++i) {
      simulation.step();
      if (i % 5 == 0) check();
    }
    simulation.seek(1000);
    check();
    const double rounding = double(glm::length(origin)) * 2e-7;  // of the coordinates
    EXPECT_GT(deepest, 0.01 - 1e-4 - rounding) << "bodies of 1 cm: " << where;
  }
}

TEST_F(CollideTest, ALongWayAmongManySolidsIsGoneInSeveralDispatchesToTheSameBits) {
  std::vector<Solid> solids;
  for (int i = 0; i < 400; ++i)
    solids.push_back({.kind = SolidKind::kSphere,
                      .position = {float(i % 20) - 9.5f, -1, float(i / 20) - 9.5f},
                      .radius_m = 0.4f});
  Emitter e = falling({.bounce = 0.6f, .friction = 0.1f, .radius_m = 0.02f}, 16);
  e.spawn.rate = {{0, 40}, {90, 40}};
  e.spawn.life_ticks = {30, 120};
  e.motion.speed = {0, 3};
  shared::EmitterData hardest{};
  hardest.round_count = uint32_t(solids.size());
  ASSERT_LT(LoopsPerTick(hardest, 0).ticks_per_dispatch(), 30u) << "or there is nothing to cut";
  const Effect effect = effect_of({e});
  Simulation stepped = simulate(effect, {.solids = solids}), sought = simulate(effect, {.solids = solids});
  stepped.seek(0);
  for (const uint32_t tick : {20u, 45u, 100u}) {
    while (stepped.tick() < tick) stepped.step();
    sought.seek(tick);
    EXPECT_EQ(stepped.state_hash(), sought.state_hash()) << "tick " << tick;
  }
}

}  // namespace
}  // namespace plume
