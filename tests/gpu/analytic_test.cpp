// Analytic emitters keep no state, and draw what stepping would have.
#include <glm/gtc/packing.hpp>

#include "tests/gpu/particle_looks.h"

namespace plume {
namespace {

constexpr double kTickSeconds = 1.0 / kTicksPerSecond;

class Analytic : public ParticleCards {
 protected:
  /// Births all along, thrown up and away.
  static Emitter thrown(float drag) {
    Emitter e;
    e.name = "thrown";
    e.spawn.bursts = {{0, 50}};
    e.spawn.rate = {{0, 130}, {400, 70}};
    e.spawn.life_ticks = {60, 240};
    e.shape = {.kind = ShapeKind::kCone, .radius_m = 0.5f, .angle_deg = 30};
    e.motion.speed = {2, 9};
    e.motion.velocity = {1, 0, -0.5f};
    e.motion.gravity = 1;
    e.motion.drag = drag;
    e.look.texture = TextureKind::kDisc;
    e.look.opacity = Curve(0.5f);
    e.look.radius_m = Curve(0.1f);
    return e;
  }
  static Effect effect_of(std::vector<Emitter> emitters) {
    return {.id = "test",
            .name = "",
            .description = "",
            .layers = {},
            .emitters = std::move(emitters),
            .meshes = {{.id = "face", .triangles = {{{{-1, 0, 0}, {1, 0, 0}, {0, 1, 0.2f}}}}}}};
  }
  Simulation called(const Effect& effect, std::optional<Path> path = {}) {
    return Simulation(device, pipelines,
                      {{.name = "test",
                        .effect = &effect,
                        .tick = 0,
                        .position = {0, 1, -4},
                        .path = std::move(path),
                        .yaw_deg = 30,
                        .seed = 1}},
                      1, {0.7f, 0, 0.2f});
  }
  /// Cards at ticks on the way, analytic against stepped: at most this far apart over the way flown, and of
  /// the same looks.
  void expect_as_stepped(Emitter e, std::optional<Path> path = {}) {
    const Effect stepped = effect_of({e});
    e.motion.analytic = true;
    const Effect analytic = effect_of({e});
    Simulation a = called(stepped, path), b = called(analytic, path);
    double worst = 0;
    size_t shown = 0;
    for (const uint32_t tick : {0u, 1u, 2u, 61u, 62u, 239u, 240u, 400u, 600u}) {
      a.go_to(tick), b.go_to(tick);
      ASSERT_EQ(a.cards(), b.cards());
      if (a.cards() == 0) continue;
      const auto expected = cards_of(a), got = cards_of(b);
      for (size_t i = 0; i < got.size(); ++i) {
        ASSERT_EQ(expected[i].optical_depth > 0, got[i].optical_depth > 0) << i << " at tick " << tick;
        if (!(expected[i].optical_depth > 0)) continue;
        ++shown;
        worst = std::max(worst, double(glm::length(expected[i].center - got[i].center)));
        worst = std::max(worst, double(glm::length(expected[i].axis_u - got[i].axis_u)));
        EXPECT_NEAR(expected[i].optical_depth, got[i].optical_depth, 1e-3 * expected[i].optical_depth);
        EXPECT_EQ(expected[i].ambient, got[i].ambient);
        for (const auto word : {0, 1}) {
          const auto difference =
              glm::unpackHalf2x16(expected[i].motion[word]) - glm::unpackHalf2x16(got[i].motion[word]);
          EXPECT_LT(glm::length(difference), 2e-4) << "metres a tick, in halves";
        }
      }
    }
    EXPECT_GT(shown, 300u);
    EXPECT_LT(worst, 6e-4) << "metres, of ways up to 40: what 240 steps round, which was 3.2e-4";
  }
};

TEST_F(Analytic, DrawsWhatSteppingWouldHave) {
  for (const float drag : {0.0f, 1e-4f, 0.05f, 0.8f, 60.0f}) {
    SCOPED_TRACE(drag);
    expect_as_stepped(thrown(drag));
  }
}

TEST_F(Analytic, DrawsMeshesRibbonsStretchedAndDisplacedCardsOnAPathToo) {
  Emitter stretched = thrown(0.5f);
  stretched.look.stretch_s = 0.05f;
  stretched.motion.curl_displacement = {.amplitude_m = 0.2f, .scale_m = 2};
  expect_as_stepped(stretched, Path({{0, {0, 0, 0}}, {100, {8, 0, 0}}, {300, {8, 3, -2}}}));
  Emitter shards = thrown(0.5f);
  shards.look.meshes = {{.id = "face", .file = ""}}, shards.look.texture = TextureKind::kSolid;
  shards.look.tumble_deg_s = {90, 360};
  expect_as_stepped(shards);
  Emitter ribbon = thrown(0.5f);
  ribbon.look.ribbon = true, ribbon.look.texture = TextureKind::kSoft, ribbon.look.ribbon_births = 8;
  ribbon.motion.speed = {5, 5}, ribbon.shape = {.kind = ShapeKind::kPoint};
  ribbon.spawn.bursts.clear();
  ribbon.spawn.rate = {{0, 30}, {400, 30}};
  expect_as_stepped(ribbon);
}

TEST_F(Analytic, AgreesWithTheSumOfItsStepsInDoublePrecision) {
  for (const double drag : {0.0, 1e-5, 0.3, 25.0}) {
    Emitter e = thrown(float(drag));
    e.shape = {.kind = ShapeKind::kPoint};
    e.motion.speed = {0, 0}, e.motion.velocity = {3, 11, -2};
    e.spawn.bursts = {{0, 1}}, e.spawn.rate.clear();
    e.spawn.life_ticks = {30'000, 30'000};
    e.motion.analytic = true;
    e.look.camera_offset_m = 0;
    const Effect effect = effect_of({e});
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = {0, 0, -1e4f}, .yaw_deg = 0, .seed = 1}},
        1, {0.7f, 0, 0.2f});
    const glm::dvec3 wind(0.7f, 0, 0.2f);
    glm::dvec3 place(0, 0, -1e4), velocity(3, 11, -2);
    for (uint32_t tick = 0; tick <= 6000; ++tick) {
      if (tick % 1500 == 0) {
        simulation.go_to(tick);
        const glm::dvec3 center(cards_of(simulation).at(0).center);
        const double way = glm::length(place - glm::dvec3(0, 0, -1e4)) + 1e4;  // the origin rounds too
        EXPECT_LT(glm::length(center - place), 1e-6 * way) << "drag " << drag << " at tick " << tick;
      }
      velocity = wind + (velocity + glm::dvec3(0, -9.81 * kTickSeconds, 0) - wind) /
                            (1 + double(float(drag)) * kTickSeconds);
      place += velocity * kTickSeconds;
    }
  }
}

TEST_F(Analytic, HasNoStateAndNoDispatch) {
  Emitter e = thrown(0.5f);
  e.motion.analytic = true;
  const Effect effect = effect_of({e});
  gpu::Pipelines own(device, shaders);
  Simulation simulation(
      device, own,
      {{.name = "test", .effect = &effect, .tick = 0, .position = {0, 0, 0}, .yaw_deg = 0, .seed = 1}}, 1,
      {});
  EXPECT_TRUE(simulation.go_to(200).empty());
  EXPECT_TRUE(simulation.go_to(201).empty());
  EXPECT_GT(simulation.cards(), 300u);
  EXPECT_TRUE(simulation.particles().empty());
  EXPECT_EQ(0u, device.memory().owner_bytes("particles"));
  EXPECT_EQ(0u, own.count()) << "pipelines";
  const InstanceDemand demand = simulation.demand()[0];
  EXPECT_TRUE(demand.awake);
  EXPECT_EQ(0u, demand.bytes);
  EXPECT_EQ(0u, demand.dispatches);
  EXPECT_EQ(0u, demand.ticks_simulated);
}

TEST_F(Analytic, ChildrenAreBornWhereTheirAnalyticParentIsDrawn) {
  Emitter drops = thrown(0.5f);
  drops.motion.analytic = true;
  drops.spawn.bursts = {{0, 40}}, drops.spawn.rate.clear();
  drops.spawn.life_ticks = {60, 60};
  Emitter splash = thrown(0);
  splash.name = "splash";
  splash.spawn = {.rate = {}, .bursts = {}, .life_ticks = {5, 5}};
  splash.parent = Parent{.emitter = "thrown", .index = 0, .event = BirthEvent::kDeath};
  splash.shape = {.kind = ShapeKind::kPoint};
  splash.motion = {};
  const Effect effect = effect_of({drops, splash});
  Simulation simulation = called(effect);
  simulation.go_to(59);
  const auto last = cards_of(simulation);
  const auto owners = cards_by_emitter(simulation.instances());
  ASSERT_EQ(2u, owners.size());
  simulation.go_to(60);
  const auto particles = simulation.particles();  // of the splash alone
  ASSERT_EQ(40u, particles.size());
  for (size_t i = 0; i < 40; ++i) {
    const shared::Card& drop = last[owners[0].first + i];
    ASSERT_GT(drop.optical_depth, 0.0f);
    const glm::vec2 xy = glm::unpackHalf2x16(drop.motion[0]), z = glm::unpackHalf2x16(drop.motion[1]);
    const glm::vec3 next = drop.center + glm::vec3(xy, z.x);  // but for what a tick's forces change
    EXPECT_LT(glm::length(next - particles[i].position), 0.006f) << i;
  }
}

}  // namespace
}  // namespace plume
