// Births and forces against the same rules in double precision, and what the camera offset does to a card.
#include <algorithm>
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <map>

#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr double kTick = 1.0 / 60;

class MotionTest : public GpuTest {
 protected:
  static Emitter emitter(uint32_t count = 400) {
    Emitter e;
    e.name = "test";
    e.spawn.bursts = {{0, count}};
    e.spawn.life_ticks = {1000, 1000};
    e.look.cross_section_m2 = 0.1f;
    return e;
  }
  std::vector<shared::Particle> particles_at(const Emitter& e, uint32_t tick, glm::vec3 wind = {},
                                             glm::vec3 origin = {}) {
    const Effect effect{.id = "test", .name = "", .description = "", .emitters = {e}};
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = origin, .yaw_deg = 0, .seed = 1}}, 1,
        wind);
    simulation.seek(tick);
    return simulation.particles();
  }
};

TEST_F(MotionTest, EveryShapeGivesBirthInsideItselfAndFillsIt) {
  const glm::vec3 origin{1, 2, 3};
  const auto births = [&](Shape shape) {
    Emitter e = emitter();
    e.shape = shape;
    std::vector<glm::vec3> places;
    for (const auto& p : particles_at(e, 0, {}, origin)) places.push_back(p.position - origin);
    EXPECT_EQ(400u, places.size());
    return places;
  };
  const auto farthest = [](const std::vector<glm::vec3>& places) {
    float most = 0;
    for (const glm::vec3& p : places) most = std::max(most, glm::length(p));
    return most;
  };
  EXPECT_LT(farthest(births({.kind = ShapeKind::kPoint})), 1e-6f);

  const auto sphere = births({.kind = ShapeKind::kSphere, .radius_m = 2});
  EXPECT_LE(farthest(sphere), 2.0001f);
  EXPECT_GT(farthest(sphere), 1.9f);
  EXPECT_LT(std::ranges::min(sphere, {}, &glm::vec3::y).y, -1.0f);
  for (const glm::vec3& p : births({.kind = ShapeKind::kSphere, .radius_m = 2, .thickness = 0}))
    EXPECT_NEAR(2.0f, glm::length(p), 1e-3f);

  const auto hemisphere = births({.kind = ShapeKind::kHemisphere, .radius_m = 2});
  EXPECT_GE(std::ranges::min(hemisphere, {}, &glm::vec3::y).y, -1e-6f);
  EXPECT_GT(farthest(hemisphere), 1.9f);

  for (const glm::vec3& p : births({.kind = ShapeKind::kBox, .size_m = {2, 1, 4}}))
    EXPECT_TRUE(std::abs(p.x) <= 1.0001f && std::abs(p.y) <= 0.5001f && std::abs(p.z) <= 2.0001f);
  for (const glm::vec3& p : births({.kind = ShapeKind::kRing, .radius_m = 3, .thickness = 0}))
    EXPECT_NEAR(3.0f, glm::length(glm::vec2(p.x, p.z)), 1e-3f);

  Emitter cone = emitter();
  cone.shape = {.kind = ShapeKind::kCone, .radius_m = 0.5f, .angle_deg = 30};
  cone.motion.speed = {2, 3};
  for (const auto& p : particles_at(cone, 0)) {
    EXPECT_LE(glm::length(p.position), 0.5001f);
    EXPECT_GE(glm::length(p.velocity), 1.999f);
    EXPECT_LE(glm::length(p.velocity), 3.001f);
    EXPECT_GE(glm::normalize(p.velocity).y, std::cos(glm::radians(30.01f)));
  }
}

TEST_F(MotionTest, ALineGivesBirthEvenlyAlongItAndThrowsAcrossIt) {
  Emitter e = emitter(2000);
  e.shape = {.kind = ShapeKind::kLine, .to_m = {1, 2, -2}};
  e.motion.speed = {2, 2};
  const glm::dvec3 along = glm::dvec3(e.shape.to_m) / 3.0;
  std::array<int, 20> births{};
  glm::dvec3 mean(0);
  for (const auto& p : particles_at(e, 0)) {
    const double at = glm::dot(glm::dvec3(p.position), along) / 3;
    EXPECT_LT(glm::length(glm::dvec3(p.position) - along * at * 3.0), 1e-6);
    ASSERT_TRUE(at >= 0 && at < 1);
    ++births[size_t(at * 20)];
    EXPECT_NEAR(2, glm::length(p.velocity), 1e-5);
    EXPECT_NEAR(0, glm::dot(glm::dvec3(p.velocity), along), 1e-5);
    mean += glm::dvec3(p.velocity) / 2000.0;
  }
  double chi2 = 0;
  for (const int n : births) chi2 += (n - 100.0) * (n - 100.0) / 100;
  EXPECT_LT(chi2, 43.8) << "19 degrees of freedom: one in a thousand";
  EXPECT_LT(glm::length(mean), 0.15) << "to all sides alike";
}

TEST_F(MotionTest, AMeshGivesBirthEvenlyOnItsSurfaceAndThrowsAlongItsNormal) {
  // A flat quarter of a box's side and two large triangles: shares of 1, 8 and 16 of 25, each cut into four.
  Effect effect{.id = "test", .name = "", .description = "", .emitters = {emitter(5000)}};
  effect.meshes = {{.id = "m",
                    .triangles = {{{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}},
                                  {{{0, 0, 0}, {0, 0, 2}, {0, 4, 0}}},
                                  {{{0, 0, 0}, {4, 0, 4}, {0, 4, 0}}}}}};
  Emitter& e = effect.emitters[0];
  e.shape = {.kind = ShapeKind::kMesh, .mesh = {.id = "m"}, .scale = 0.5f};
  e.motion.speed = {3, 3};
  Simulation simulation(
      device, pipelines,
      {{.name = "test", .effect = &effect, .tick = 0, .position = {1, 2, 3}, .yaw_deg = 90}}, 1, {});
  simulation.seek(0);
  std::map<std::pair<size_t, int>, int> births;
  double whole = 0;
  std::vector<double> areas;
  for (const auto& t : effect.meshes[0].triangles) {
    areas.push_back(double(glm::length(glm::cross(t[1] - t[0], t[2] - t[0]))));
    whole += areas.back();
  }
  for (const auto& p : simulation.particles()) {
    const glm::dvec3 q = glm::dvec3(p.position) - glm::dvec3(1, 2, 3), v(p.velocity);
    const glm::dvec3 place = glm::dvec3(-q.z, q.y, q.x) * 2.0, out = glm::dvec3(-v.z, v.y, v.x) / 3.0;
    int found = 0;
    for (size_t i = 0; i < 3; ++i) {
      const auto& t = effect.meshes[0].triangles[i];
      const glm::dvec3 a(t[0]), u = glm::dvec3(t[1]) - a, w = glm::dvec3(t[2]) - a;
      const glm::dvec3 normal = glm::normalize(glm::cross(u, w));
      if (glm::length(normal - out) > 1e-5) continue;
      ++found;
      EXPECT_LT(std::abs(glm::dot(place - a, normal)), 2e-6) << "on the plane";
      const glm::dmat2 gram(glm::dot(u, u), glm::dot(u, w), glm::dot(u, w), glm::dot(w, w));
      const glm::dvec2 at = glm::inverse(gram) * glm::dvec2(glm::dot(place - a, u), glm::dot(place - a, w));
      EXPECT_TRUE(at.x > -1e-6 && at.y > -1e-6 && at.x + at.y < 1 + 1e-6) << at.x << ", " << at.y;
      const int quarter = at.x > 0.5 ? 0 : at.y > 0.5 ? 1 : at.x + at.y < 0.5 ? 2 : 3;
      ++births[{i, quarter}];
    }
    ASSERT_EQ(1, found) << "outwards is the normal of one triangle";
  }
  double chi2 = 0;
  for (const auto& [place, n] : births) {
    const double expected = 5000 * areas[place.first] / whole / 4;
    chi2 += (n - expected) * (n - expected) / expected;
  }
  EXPECT_EQ(12u, births.size());
  EXPECT_LT(chi2, 31.3) << "11 degrees of freedom: one in a thousand";
}

TEST_F(MotionTest, GravityDragWindAndBuoyancyFollowTheRecurrenceInDoublePrecision) {
  Emitter e = emitter(50);
  e.motion.velocity = {1.0f, 4.0f, -2.0f};
  e.motion.gravity = 0.5f;
  e.motion.drag = 0.7f;
  e.motion.buoyancy = 3.0f;
  e.motion.cooling_s = 0.8f;
  e.motion.wind = 0.5f;
  const glm::vec3 wind{2, 0, 1};
  glm::dvec3 position(0), velocity(e.motion.velocity);
  const glm::dvec3 carried = glm::dvec3(wind) * 0.5;
  for (int age = 0; age < 120; ++age) {
    const glm::dvec3 acceleration(0, -9.81 * 0.5 + 3.0 * std::exp(-age * kTick / double(e.motion.cooling_s)),
                                  0);
    velocity += acceleration * kTick;
    velocity = carried + (velocity - carried) / (1 + double(e.motion.drag) * kTick);
    position += velocity * kTick;
  }
  for (const auto& p : particles_at(e, 120, wind)) {
    EXPECT_LT(glm::length(glm::dvec3(p.position) - position), 1e-3) << "after two seconds of float steps";
    EXPECT_LT(glm::length(glm::dvec3(p.velocity) - velocity), 1e-3);
  }
}

TEST_F(MotionTest, AVortexTurnsAroundItsAxisAndPullsInwards) {
  Emitter e = emitter();
  e.shape = {.kind = ShapeKind::kRing, .radius_m = 1, .thickness = 0};
  e.motion.vortex = {.strength = 2, .radius_m = 1, .pull = 0};
  for (const auto& p : particles_at(e, 1)) {
    const glm::vec2 arm(p.position.x, p.position.z), v(p.velocity.x, p.velocity.z);
    EXPECT_NEAR(2.0 * kTick, glm::dot(v, glm::vec2(-arm.y, arm.x)), 1e-3)
        << "tangential speed after a tick at the core radius";
    EXPECT_NEAR(0.0, glm::dot(v, arm), 2e-3);
  }
  e.motion.vortex = {.strength = 0, .radius_m = 1, .pull = 3};
  for (const auto& p : particles_at(e, 1))
    EXPECT_NEAR(-3.0 * kTick,
                glm::dot(glm::vec2(p.velocity.x, p.velocity.z), glm::vec2(p.position.x, p.position.z)), 1e-3);
}

TEST_F(MotionTest, CurlNoiseStirsWithoutACommonDrift) {
  Emitter e = emitter(4000);
  e.shape = {.kind = ShapeKind::kSphere, .radius_m = 20};
  e.motion.curl = {.strength = 1.0f, .scale_m = 2.0f, .speed = 0.0f, .octaves = 1};
  const auto moved = particles_at(e, 1);
  double speed = 0;
  glm::dvec3 drift(0);
  for (const auto& p : moved) {
    speed += glm::length(p.velocity) / double(moved.size());
    drift += glm::dvec3(p.velocity) / double(moved.size());
  }
  EXPECT_GT(speed, 0.2 * kTick);
  EXPECT_LT(speed, 4.0 * kTick);
  EXPECT_LT(glm::length(drift), 0.15 * speed);
}

TEST_F(MotionTest, TheFloorHoldsWhatFalls) {
  Emitter e = emitter(50);
  e.motion.gravity = 1;
  e.motion.floor_y = -0.5f;
  for (const auto& p : particles_at(e, 200)) EXPECT_FLOAT_EQ(-0.5f, p.position.y);
}

TEST_F(MotionTest, ACameraOffsetMovesTheCardAlongItsRayAndKeepsItsSizeOnScreen) {
  Scene scene;
  scene.camera = {{.tick = 0, .position = {0, 1, 10}, .target = {0, 1, 0}, .vertical_fov_deg = 50}};
  const auto view =
      gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, scene.camera[0], {64, 36}, 0)});
  const auto card_with = [&](float offset) {
    Emitter e = emitter(1);
    e.look.camera_offset_m = offset;
    const Effect effect{.id = "test", .name = "", .description = "", .emitters = {e}};
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = {2, 2, 0}, .yaw_deg = 0, .seed = 1}}, 1,
        {});
    simulation.seek(0);
    const gpu::Buffer cards(device, {.owner = "test", .label = "cards", .bytes = sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    return gpu::read<shared::Card>(device, cards)[0];
  };
  const shared::Card plain = card_with(0), nearer = card_with(1.5f);
  const glm::vec3 camera{0, 1, 10};
  EXPECT_NEAR(10.0f, camera.z - plain.center.z, 1e-4f);
  EXPECT_NEAR(8.5f, camera.z - nearer.center.z, 1e-4f);
  const float scale = 8.5f / 10.0f;
  EXPECT_LT(glm::length((nearer.center - camera) - (plain.center - camera) * scale), 1e-4f)
      << "not on the same ray";
  EXPECT_NEAR(glm::length(plain.axis_u) * scale, glm::length(nearer.axis_u), 1e-5f);
  EXPECT_FLOAT_EQ(plain.optical_depth, nearer.optical_depth);
}

TEST_F(MotionTest, AGrowingPuffThinsAsItsCrossSectionSays) {
  Scene scene;
  scene.camera = {{.tick = 0, .position = {0, 0, 10}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
  const auto view =
      gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, scene.camera[0], {64, 36}, 0)});
  for (const float radius : {0.3f, 1.0f, 2.5f}) {
    Emitter e = emitter(1);
    e.look.radius_m = Curve(radius);
    e.look.cross_section_m2 = 0.8f;
    const Effect effect{.id = "test", .name = "", .description = "", .emitters = {e}};
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = {}, .yaw_deg = 0, .seed = 1}}, 1, {});
    simulation.seek(10);
    const gpu::Buffer cards(device, {.owner = "test", .label = "cards", .bytes = sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    EXPECT_NEAR(0.8 / (M_PI * radius * radius), gpu::read<shared::Card>(device, cards)[0].optical_depth,
                1e-4 / radius);
  }
}

TEST_F(MotionTest, ANearFadeThinsByTheDistanceToTheCamera) {
  // Coverage and light fall in one proportion, and nothing changes beyond.
  Scene scene;
  scene.camera = {{.tick = 0, .position = {0, 0, 0}, .target = {0, 0, -10}, .vertical_fov_deg = 50}};
  const auto view =
      gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, scene.camera[0], {64, 36}, 0)});
  const auto card_at = [&](glm::vec3 position, float near_fade) {
    Emitter e = emitter(1);
    e.look.radius_m = Curve(0.05f);
    e.look.emission = Gradient(glm::vec3(8, 4, 2));
    e.look.near_fade_m = near_fade;
    const Effect effect{.id = "test", .name = "", .description = "", .emitters = {e}};
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = position, .yaw_deg = 0, .seed = 1}}, 1,
        {});
    simulation.seek(0);
    const gpu::Buffer cards(device, {.owner = "test", .label = "cards", .bytes = sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    return gpu::read<shared::Card>(device, cards)[0];
  };
  for (const glm::vec3 position : {glm::vec3(0, 0, -0.5f), {1.5f, -0.5f, -2}, {0, 0, -4}, {3, 1, -30}}) {
    const shared::Card whole = card_at(position, 0), faded = card_at(position, 4);
    const float share = std::min(glm::length(position) / 4.0f, 1.0f);
    EXPECT_NEAR(share, faded.optical_depth / whole.optical_depth, 1e-6);
    EXPECT_NEAR(8 * share, glm::unpackHalf2x16(faded.emission.x).x, 8.0f / 2048);
    EXPECT_EQ(whole.axis_u, faded.axis_u);
  }
}

TEST_F(MotionTest, TheSmokeGrenadeIs512PuffsIn45Seconds) {
  const Effect effect = library.effect("smoke_grenade");
  ASSERT_EQ(1u, effect.emitters.size());
  const SpawnSchedule schedule(effect.emitters[0].spawn);
  EXPECT_EQ(512u, schedule.births_total());
  EXPECT_LE(schedule.last_tick(), 45u * kTicksPerSecond);
  EXPECT_GT(schedule.last_tick(), 44u * kTicksPerSecond);
  EXPECT_TRUE(effect.emitters[0].look.cross_section_m2.has_value());
}

}  // namespace
}  // namespace plume
