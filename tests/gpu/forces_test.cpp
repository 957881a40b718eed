// Attractors, vector fields, orbits, kill volumes and displacement: against closed forms and the same rules
// in double precision.
#include <algorithm>
#include <random>

#include "sandbox/presets/read_field.h"
#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/gpu/moving_particles.h"

namespace plume {
namespace {

class ForcesTest : public MovingParticles {
 protected:
  /// `vector_at` gives the vector at a place.
  template <class VectorAt>
  static VectorField field(glm::uvec3 size, glm::vec3 low, glm::vec3 high, VectorAt vector_at) {
    auto grid = std::make_shared<FieldGrid>(FieldGrid{.size = size, .low = low, .high = high, .cells = {}});
    for (uint32_t z = 0; z < size.z; ++z)
      for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x)
          grid->cells.push_back(
              vector_at(low + (glm::vec3(x, y, z) + 0.5f) * (high - low) / glm::vec3(size)));
    return {.id = "test", .grid = grid, .offset_m = {}};
  }

  static glm::dvec3 attraction(const Attractor& a, glm::dvec3 place) {
    const glm::dvec3 from(a.from_m), along = glm::dvec3(a.to_m) - from;
    const double square = glm::dot(along, along);
    const double t = square > 0 ? std::clamp(glm::dot(place - from, along) / square, 0.0, 1.0) : 0.0;
    const glm::dvec3 arm = from + along * t - place;
    const double q2 = glm::dot(arm, arm) / (double(a.radius_m) * double(a.radius_m));
    return arm * (double(a.strength) * std::pow(2.0, 1.5) / double(a.radius_m) / std::pow(1 + q2, 1.5));
  }
};

TEST_F(ForcesTest, AParticleCirclesAPointAttractorAtTheSpeedThatBalancesIt) {
  const Attractor centre{.from_m = {-2, 0, 0}, .to_m = {-2, 0, 0}, .strength = 3, .radius_m = 1};
  Emitter e = emitter(1);
  e.motion.attractors = {centre};
  e.motion.velocity = {0, 0, float(std::sqrt(2 * 3 * std::pow(2.0, 1.5) * 2 / std::pow(5.0, 1.5)))};
  glm::dvec3 position(0), velocity(e.motion.velocity);
  for (const auto& p : track(e, 300, {})) {
    EXPECT_LT(glm::length(glm::dvec3(p.position) - position), 1e-3);
    EXPECT_NEAR(2.0, glm::length(p.position - centre.from_m), 0.02) << "half a tick of the pull";
    velocity += attraction(centre, position) * kTickSeconds;
    position += velocity * kTickSeconds;
  }
}

TEST_F(ForcesTest, AnAttractorHasItsStrengthAtItsRadiusAndNoneInItsCentre) {
  Emitter e = emitter(1);
  e.motion.attractors = {{.from_m = {0, 3, 0}, .to_m = {0, 3, 0}, .strength = 5, .radius_m = 3}};
  EXPECT_NEAR(5 * kTickSeconds, particles_at(e, 1)[0].velocity.y, 1e-6);
  e.motion.attractors[0].strength = -5;
  EXPECT_NEAR(-5 * kTickSeconds, particles_at(e, 1)[0].velocity.y, 1e-6) << "it does not repel";
  e.motion.attractors[0].from_m = e.motion.attractors[0].to_m = {0, 0, 0};
  EXPECT_EQ(glm::vec3(0), particles_at(e, 60)[0].position);
}

TEST_F(ForcesTest, ALineAttractorPullsAcrossItselfBetweenItsEndsAndToThemBeyond) {
  Emitter e = emitter(400);
  e.shape = {.kind = ShapeKind::kBox, .size_m = {4, 4, 4}};
  const Attractor line{.from_m = {-1, 0.3f, 0}, .to_m = {1, 0.3f, 0}, .strength = 4, .radius_m = 0.5f};
  e.motion.attractors = {line};
  const auto born = particles_at(e, 0), moved = particles_at(e, 1);
  size_t beside = 0;
  for (size_t i = 0; i < born.size(); ++i) {
    const glm::dvec3 expected = attraction(line, glm::dvec3(born[i].position)) * kTickSeconds;
    EXPECT_LT(glm::length(glm::dvec3(moved[i].velocity) - expected), 1e-5);
    if (std::abs(born[i].position.x) >= 1) continue;
    ++beside;
    EXPECT_NEAR(0.0f, moved[i].velocity.x, 1e-6f) << "pulled along the line";
  }
  EXPECT_GT(beside, 100u);
}

TEST_F(ForcesTest, AnOrbitTurnsPlacesAndVelocitiesAboutTheAxisAndKeepsTheRadius) {
  Emitter e = emitter(50);
  e.shape = {.kind = ShapeKind::kRing, .radius_m = 2, .thickness = 0.5f};
  e.motion.orbit = 0.5f;
  const Place place{.origin = {3, 1, -2}};
  const auto born = particles_at(e, 0, place), quarter = particles_at(e, 30, place),
             full = particles_at(e, 120, place);
  for (size_t i = 0; i < born.size(); ++i) {
    const glm::vec3 arm = born[i].position - place.origin;
    EXPECT_LT(glm::length(quarter[i].position - place.origin - glm::vec3(arm.z, arm.y, -arm.x)), 1e-4f);
    EXPECT_LT(glm::length(full[i].position - born[i].position), 1e-4f) << "not back after a revolution";
  }
  e.shape = {};
  e.motion.velocity = {0, 2, 0.5f};
  const auto moving = particles_at(e, 30);
  EXPECT_LT(glm::length(moving[0].velocity - glm::vec3(0.5f, 2, 0)), 1e-4f) << "the velocity does not turn";
}

TEST_F(ForcesTest, AConstantFieldIsAUniformAccelerationInsideItsBoundsAndNothingOutside) {
  Emitter e = emitter(1);
  e.motion.field =
      field({2, 3, 1}, {-50, -50, -50}, {50, 50, 50}, [](glm::vec3) { return glm::vec3(1, -2, 0.5f); });
  e.motion.field->strength = 2;
  const glm::dvec3 a(2, -4, 1);
  const auto p = particles_at(e, 120)[0];
  EXPECT_LT(glm::length(glm::dvec3(p.velocity) - a * 2.0), 1e-3);
  EXPECT_LT(glm::length(glm::dvec3(p.position) - a * (120.0 * 121 / 2) * kTickSeconds * kTickSeconds), 1e-3);
  e.motion.field->offset_m = {51, 0, 0};
  EXPECT_EQ(glm::vec3(0), particles_at(e, 120)[0].position);
}

TEST_F(ForcesTest, AFieldIsLinearBetweenCellsAndScalesAndTurnsWithItsEmitter) {
  Emitter e = emitter(300);
  e.shape = {.kind = ShapeKind::kBox,
             .size_m = {5, 5, 5}};  // within the outermost centres, 3 m from the middle
  const glm::mat3 m(1, 0.5f, 0, -0.3f, 2, 0.1f, 0, 0.7f, -1);
  e.motion.field = field({4, 4, 4}, {-2, -2, -2}, {2, 2, 2}, [&](glm::vec3 x) { return m * x; });
  e.motion.field->scale = 2;
  const Place place{.origin = {10, 0, 5}, .yaw_deg = 90};
  const auto born = particles_at(e, 0, place), moved = particles_at(e, 1, place);
  for (size_t i = 0; i < born.size(); ++i) {
    const glm::vec3 arm = born[i].position - place.origin;  // turned: (x, z) -> (z, -x)
    const glm::vec3 local = m * (glm::vec3(-arm.z, arm.y, arm.x) * 0.5f);
    const glm::vec3 expected = glm::vec3(local.z, local.y, -local.x) * float(kTickSeconds);
    EXPECT_LT(glm::length(moved[i].velocity - expected), 1e-5f);
  }
}

TEST_F(ForcesTest, AFieldOfVelocitiesIsWhatDragPullsTo) {
  Emitter e = emitter(1);
  e.motion.field =
      field({1, 1, 1}, {-50, -50, -50}, {50, 50, 50}, [](glm::vec3) { return glm::vec3(1, 2, 3); });
  e.motion.field->use = VectorField::Use::kVelocity;
  e.motion.drag = 1.5f;
  const glm::vec3 wind{0.5f, 0, 0};
  const double left = std::pow(1 + 1.5 * kTickSeconds, -90);
  const auto p = particles_at(e, 90, {.wind = wind})[0];
  EXPECT_LT(glm::length(glm::dvec3(p.velocity) - glm::dvec3(1.5, 2, 3) * (1 - left)), 1e-5);
}

TEST_F(ForcesTest, AllForcesTogetherFollowTheRecurrenceInDoublePrecision) {
  Emitter e = emitter(40);
  e.shape = {.kind = ShapeKind::kSphere, .radius_m = 1};
  e.motion.speed = {0.5f, 1};
  e.motion.gravity = 0.2f;
  e.motion.buoyancy = 1.5f;
  e.motion.drag = 0.6f;
  e.motion.vortex = {.strength = 1.2f, .radius_m = 0.7f, .pull = 0.4f};
  e.motion.orbit = 0.1f;
  e.motion.attractors = {{.from_m = {1, 0, 0}, .to_m = {1, 2, 0}, .strength = 2, .radius_m = 0.8f},
                         {.from_m = {-1, 1, 1}, .to_m = {-1, 1, 1}, .strength = -1, .radius_m = 0.5f}};
  const Place place{.wind = {0.3f, 0, -0.2f}};
  const auto born = particles_at(e, 0, place), moved = particles_at(e, 90, place);
  const double angle = 2 * M_PI * double(e.motion.orbit) * kTickSeconds;
  const auto turn = [&](glm::dvec3 v) {
    return glm::dvec3(v.x * std::cos(angle) + v.z * std::sin(angle), v.y,
                      v.z * std::cos(angle) - v.x * std::sin(angle));
  };
  for (size_t i = 0; i < born.size(); ++i) {
    glm::dvec3 position(born[i].position), velocity(born[i].velocity);
    const glm::dvec3 wind(place.wind);
    for (int age = 0; age < 90; ++age) {
      glm::dvec3 a(0, -9.81 * double(e.motion.gravity) + 1.5 * std::exp(-age * kTickSeconds), 0);
      const glm::dvec2 arm(position.x, position.z);
      const double distance = glm::length(arm), q = distance / double(e.motion.vortex.radius_m);
      const glm::dvec2 swirl =
          glm::dvec2(-arm.y, arm.x) / distance * (double(e.motion.vortex.strength) * 2 * q / (1 + q * q)) -
          arm / distance * double(e.motion.vortex.pull);
      a += glm::dvec3(swirl.x, 0, swirl.y);
      for (const Attractor& attractor : e.motion.attractors) a += attraction(attractor, position);
      velocity += a * kTickSeconds;
      velocity = wind + (velocity - wind) / (1 + double(e.motion.drag) * kTickSeconds);
      position = turn(position + velocity * kTickSeconds);
      velocity = turn(velocity);
    }
    EXPECT_LT(glm::length(glm::dvec3(moved[i].position) - position), 2e-3) << "after 90 float steps";
    EXPECT_LT(glm::length(glm::dvec3(moved[i].velocity) - velocity), 2e-3);
  }
}

TEST_F(ForcesTest, AKillVolumeEndsAParticleInTheTickItsWayTouchesIt) {
  Emitter e = emitter(1);
  e.motion.velocity = {1, 0, 0};  // 1/60 m a tick
  const auto dies_at = [&](KillVolume volume) {
    e.motion.kill = {volume};
    uint32_t tick = 0;
    for (const auto& p : track(e, 60, {})) {
      if (is_dead(p)) return tick;
      ++tick;
    }
    return tick;
  };
  using enum KillVolume::Kind;
  const glm::vec3 far{0.495f, 0, 0};  // touched in the 30th tick
  EXPECT_EQ(30u, dies_at({.kind = kPlane, .position_m = far, .normal = {-2, 0, 0}}));
  EXPECT_EQ(30u, dies_at({.kind = kBox, .position_m = far, .size_m = {0.001f, 1, 1}}))
      << "too thin to be met";
  EXPECT_EQ(30u, dies_at({.kind = kSphere, .position_m = far, .radius_m = 0.001f})) << "too thin to be met";
  EXPECT_EQ(30u, dies_at({.kind = kBox, .size_m = {0.99f, 1, 1}, .outside = true}));
  EXPECT_EQ(30u, dies_at({.kind = kSphere, .radius_m = 0.495f, .outside = true}));
  EXPECT_EQ(1u, dies_at({.kind = kBox})) << "born inside";
  EXPECT_EQ(61u, dies_at({.kind = kBox, .position_m = {0.5f, 1, 0}})) << "it passes below";
  EXPECT_EQ(61u, dies_at({.kind = kPlane, .position_m = {0, -0.1f, 0}})) << "it stays above";
}

TEST_F(ForcesTest, DisplacementMovesWhatIsDrawnAndLeavesTheStateAlone) {
  Emitter e = emitter(100);
  e.shape = {.kind = ShapeKind::kSphere, .radius_m = 1};
  Scene scene;
  scene.camera = {{.tick = 0, .position = {0, 0, 10}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
  const auto view =
      gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, scene.camera[0], {64, 36}, 30)});
  const auto state_and_cards = [&](const Emitter& used) {
    const Effect effect = effect_of({used});
    Simulation simulation = simulate(effect, {});
    simulation.seek(30);
    const gpu::Buffer cards(device, {.owner = "test", .label = "cards", .bytes = 100 * sizeof(shared::Card)});
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) { simulation.record_cards(pass, view, cards, 0); });
    frame.finish();
    return std::pair(simulation.state_hash(), gpu::read<shared::Card>(device, cards));
  };
  const auto [plain_state, plain] = state_and_cards(e);
  e.motion.curl_displacement = {.amplitude_m = 0.2f, .scale_m = 1.0f};
  const auto [state, displaced] = state_and_cards(e);
  e.motion.curl_displacement.grow_s = 1;  // half grown at tick 30
  const auto growing = state_and_cards(e).second;
  EXPECT_EQ(plain_state, state);
  double mean = 0;
  for (size_t i = 0; i < plain.size(); ++i) {
    const glm::vec3 moved = displaced[i].center - plain[i].center;
    mean += double(glm::length(moved)) / double(plain.size());
    EXPECT_LT(glm::length(moved), 0.2f * 12) << "noise of magnitude 1 has rare peaks";
    EXPECT_LT(glm::length((growing[i].center - plain[i].center) * 2.0f - moved), 1e-4f);
  }
  EXPECT_GT(mean, 0.04);
}

/// The two noises' lattice values, and the cross product of their gradients, as shaders/effects/noise.glsl
/// has them.
glm::dvec2 lattice(glm::ivec3 p) {
  uint32_t h = uint32_t(p.x) * 0x8da6b343u ^ uint32_t(p.y) * 0xd8163841u ^ uint32_t(p.z) * 0xcb1ab31fu;
  h ^= h >> 15;
  h *= 0x2c1b3c6du;
  h ^= h >> 13;
  return glm::dvec2(h & 0xffffu, h >> 16) * (2.0 / 65535.0) - 1.0;
}
glm::dvec3 curl_noise(glm::dvec3 x) {
  const glm::ivec3 base(glm::floor(x));
  const glm::dvec3 f = x - glm::dvec3(base);
  glm::dvec3 gradients[2]{};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 side(corner & 1, corner >> 1 & 1, corner >> 2);
    glm::dvec3 weight, slope;
    for (int c = 0; c < 3; ++c) {
      const double t = f[c], u = t * t * t * (t * (t * 6 - 15) + 10), du = 30 * t * t * (t * (t - 2) + 1);
      weight[c] = side[c] ? u : 1 - u;
      slope[c] = side[c] ? du : -du;
    }
    const glm::dvec2 value = lattice(base + side);
    for (int n = 0; n < 2; ++n)
      gradients[n] += value[n] * glm::dvec3(slope.x * weight.y * weight.z, weight.x * slope.y * weight.z,
                                            weight.x * weight.y * slope.z);
  }
  return glm::cross(gradients[0], gradients[1]);
}

TEST_F(ForcesTest, CurlNoiseIsTheCrossProductOfTwoGradientsAndHasNoDivergence) {
  Emitter e = emitter(500);
  e.shape = {.kind = ShapeKind::kSphere, .radius_m = 3};
  e.motion.curl = {.strength = 2, .scale_m = 0.8f};
  const Effect effect = effect_of({e});
  Simulation simulation = simulate(effect, {});
  const Call call{.name = "test", .effect = &effect, .tick = 0, .position = {}, .yaw_deg = 0, .seed = 1};
  MeshTable no_meshes;
  const uint32_t seed = emitter_data(call, 0, 1, {}, no_meshes).seed;
  const glm::dvec3 shift(seed & 0xff, seed >> 8 & 0xff, seed >> 16 & 0xff);
  simulation.seek(0);
  const auto born = simulation.particles();
  simulation.step();
  const auto moved = simulation.particles();
  for (size_t i = 0; i < born.size(); ++i) {
    const glm::dvec3 at = glm::dvec3(born[i].position) / 0.8 + shift;
    EXPECT_LT(glm::length(glm::dvec3(moved[i].velocity) - 2.0 * curl_noise(at) * kTickSeconds), 1e-4);
    double divergence = 0;
    for (int c = 0; c < 3; ++c) {
      glm::dvec3 h(0);
      h[c] = 1e-4;
      divergence += (curl_noise(at + h)[c] - curl_noise(at - h)[c]) / 2e-4;
    }
    EXPECT_NEAR(0.0, divergence, 1e-4);
  }
}

TEST_F(ForcesTest, AnEmitterMovesTheSameWhateverItsNeighboursUse) {
  Emitter plain = emitter(50);
  plain.shape = {.kind = ShapeKind::kSphere, .radius_m = 1};
  plain.motion.speed = {0.5f, 3};
  plain.motion.gravity = 1;
  plain.motion.drag = 0.3f;
  Emitter busy = plain;
  busy.name = "busy";
  busy.motion.curl = {.strength = 2};
  busy.motion.vortex = {.strength = 2, .pull = 1};
  busy.motion.orbit = 0.3f;
  busy.motion.attractors = {{.from_m = {1, 0, 0}, .to_m = {1, 0, 0}, .strength = 2}};
  busy.motion.field = field({2, 2, 2}, {-5, -5, -5}, {5, 5, 5}, [](glm::vec3 x) { return x; });
  busy.motion.kill = {{.kind = KillVolume::Kind::kSphere, .radius_m = 8, .outside = true}};
  busy.motion.collision = Collision{.bounce = 0.5f};
  const Place place{.solids = {{.kind = SolidKind::kPlane, .position = {0, -2, 0}, .size_m = {100, 0, 100}}}};
  const Effect alone = effect_of({plain}), together = effect_of({plain, busy});
  Simulation a = simulate(alone, place), b = simulate(together, place);
  a.seek(100), b.seek(100);
  const auto expected = a.particles(), found = b.particles();
  ASSERT_EQ(50u, expected.size());
  ASSERT_EQ(100u, found.size());
  EXPECT_TRUE(
      std::ranges::equal(std::as_bytes(std::span(expected)), std::as_bytes(std::span(found).first(50))));
}

TEST_F(ForcesTest, ExtremeLegalParametersGiveFiniteStatesThatStepsAndSeeksAgreeOn) {
  std::mt19937 random(7);
  const auto pick = [&](std::initializer_list<float> values) {
    return *(values.begin() + std::uniform_int_distribution<size_t>(0, values.size() - 1)(random));
  };
  const auto point = [&] {
    return glm::vec3(pick({0, 1, -1000, 1000}), pick({0, -1, 1000}), pick({0, 0.5f, -1000}));
  };
  std::vector<Emitter> emitters;
  for (int i = 0; i < 40; ++i) {
    Emitter e = emitter(8);
    e.name = "extreme " + std::to_string(i);
    e.shape = {.kind = i % 2 ? ShapeKind::kPoint : ShapeKind::kSphere, .radius_m = pick({0.001f, 1, 1000})};
    Motion& m = e.motion;
    m.speed = {pick({0, -1000}), pick({0, 1000})};
    m.velocity = {pick({0, 1000}), pick({0, -1000}), 0};
    m.gravity = pick({0, 1, -100, 100});
    m.drag = pick({0, 0.1f, 1000});
    m.wind = pick({0, 10});
    m.buoyancy = pick({0, -1000, 1000});
    m.cooling_s = pick({0.001f, 3600});
    m.floor_y = pick({-1e30f, 0, 10'000});
    m.curl = {
        .strength = pick({0, 1000}), .scale_m = pick({0.01f, 1000}), .speed = pick({0, -100}), .octaves = 3};
    m.vortex = {.strength = pick({0, 1000}), .radius_m = pick({0.01f, 1000}), .pull = pick({0, -1000, 1000})};
    m.orbit = pick({0, 30, -30});
    for (int a = 0; a < i % 4; ++a) {
      const glm::vec3 from = point();
      m.attractors.push_back({.from_m = from,
                              .to_m = a % 2 ? point() : from,
                              .strength = pick({1000, -1000}),
                              .radius_m = pick({0.01f, 1000})});
    }
    if (i % 3 == 0) {
      m.field = field({1, 2, 3}, {-1, -1, -1}, {1, 1, 1}, [&](glm::vec3) { return point(); });
      m.field->scale = pick({0.001f, 1000});
      m.field->strength = pick({-1000, 1000});
      m.field->use = i % 2 ? VectorField::Use::kForce : VectorField::Use::kVelocity;
    }
    if (i % 5 == 0) m.kill = {{.kind = KillVolume::Kind::kSphere, .position_m = point(), .radius_m = 0.001f}};
    if (i % 2)
      m.collision = Collision{.response = i % 4 == 1 ? CollisionResponse::kBounce : CollisionResponse::kSlide,
                              .bounce = pick({0, 1}),
                              .friction = pick({0, 1}),
                              .radius_m = pick({0, 10}),
                              .event_speed = 0};
    emitters.push_back(e);
  }
  const Place place{
      .wind = {1000, 0, -1000},
      .yaw_deg = 77,
      .solids = {{.kind = SolidKind::kPlane, .position = {0, -2, 0}, .size_m = {0.001f, 0, 10'000}},
                 {.kind = SolidKind::kBox, .size_m = {0.001f, 10'000, 0.001f}, .yaw_deg = -360},
                 {.kind = SolidKind::kSphere, .radius_m = 10'000},
                 {.kind = SolidKind::kSphere, .radius_m = 0.001f},
                 {.kind = SolidKind::kCapsule, .end = {0, 0.001f, 0}, .radius_m = 10}}};
  const Effect effect = effect_of(emitters);
  Simulation sought = simulate(effect, place), stepped = simulate(effect, place);
  sought.seek(600);
  size_t living = 0;
  for (const auto& p : sought.particles()) {
    living += !is_dead(p);
    for (int c = 0; c < 3; ++c) {
      EXPECT_TRUE(std::isfinite(p.position[c]));
      EXPECT_TRUE(std::isfinite(p.velocity[c]));
    }
  }
  EXPECT_GT(living, 200u);
  stepped.seek(550);
  while (stepped.tick() < 600) stepped.step();
  EXPECT_EQ(sought.state_hash(), stepped.state_hash());
}

}  // namespace
}  // namespace plume
