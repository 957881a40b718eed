// Smoke in its own shadow and in the light of fires, against the same sums in double precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/gtc/packing.hpp>
#include <numeric>
#include <random>

#include "renderer/seen_cards.h"
#include "sandbox/effects/card_kernels.h"
#include "sandbox/scene/view.h"
#include "shaders/shared/card.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

using glm::dvec3;

constexpr double kHalfStep = 1.0 / 2048;    // relative: what rounding to half floats does
constexpr double kUnit = 1.0 / 65536;       // of the fixed-point optical depths
constexpr double kNothing = 2 * kHalfStep;  // what rounding to half floats twice may do

struct Lit {
  std::vector<shared::Card> cards;
  std::vector<shared::LitBody> bodies;
  std::vector<shared::LightGrid> grids;
  std::vector<std::byte> sun, sky;  // volumes
  std::vector<shared::FireLight> fires;
  std::vector<std::string> passes;
};

dvec3 rgb(glm::uvec2 half4) {
  return {glm::unpackHalf2x16(half4.x).x, glm::unpackHalf2x16(half4.x).y, glm::unpackHalf2x16(half4.y).x};
}

class LightingTest : public GpuTest {
 protected:
  LightingTest() {
    scene.light.sun_direction = glm::normalize(glm::vec3(-0.5f, 0.6f, 0.3f));
    scene.light.sun_color = {2.0f, 1.5f, 1.0f};
  }

  /// One particle, at rest.
  static Emitter puff(glm::vec3 place, float radius_m, float cross_section_m2) {
    Emitter e;
    e.name = "at " + std::to_string(place.x) + " " + std::to_string(place.y) + " " + std::to_string(place.z);
    e.spawn.bursts = {{0, 1}};
    e.spawn.life_ticks = {1000, 1000};
    e.shape.offset_m = place;
    e.look.radius_m = radius_m;
    e.look.cross_section_m2 = cross_section_m2;
    e.look.color = glm::vec3(1.0f);
    return e;
  }
  /// Does not cast: too narrow.
  static Emitter speck(glm::vec3 place) { return puff(place, 0.01f, 1e-4f); }
  static Emitter ember(glm::vec3 place, float radius_m, glm::vec3 radiance) {
    Emitter e = puff(place, radius_m, 0.0f);
    e.look.cross_section_m2.reset();
    e.look.opacity = 0.0f;
    e.look.lit = false;
    e.look.emission = radiance;
    return e;
  }

  Lit light(const std::vector<Emitter>& emitters, LightingOptions options = {}, uint32_t tick = 0,
            std::optional<CameraKey> camera = {}, bool step = false,
            const std::function<void(gpu::Frame&, const gpu::Buffer& view, const Lighting&)>& after = {}) {
    const Effect effect{.id = "test", .name = "", .description = "", .layers = {}, .emitters = emitters};
    Simulation simulation(
        device, pipelines,
        {{.name = "test", .effect = &effect, .tick = 0, .position = {}, .yaw_deg = 0, .seed = 1}}, 1, {});
    if (step)
      for (simulation.seek(0); simulation.tick() < tick;) simulation.step();
    else
      simulation.seek(tick);
    const gpu::Buffer view(
        device, {.owner = "test", .label = "view", .bytes = sizeof(shared::ViewData), .host_visible = true});
    view.mapped<shared::ViewData>()[0] = make_view(scene, camera.value_or(CameraKey{}), {64, 64}, tick);
    Lighting lighting(device, options, {{0u, glm::vec3(0.0f)}});
    lighting.fit(cards_by_emitter(simulation.instances()), simulation.cards());
    const uint32_t count = kPanes + simulation.cards();
    const gpu::Buffer cards(device,
                            {.owner = "test", .label = "cards", .bytes = count * sizeof(shared::Card)});
    std::vector<uint32_t> in_order(count);
    std::iota(in_order.begin(), in_order.end(), 0u);
    const auto submission = gpu::make_buffer(device, "test", "submission", in_order);
    Transparents transparents{
        .cards = &cards, .view = &view, .count = count, .counts = cards_by_source(simulation.instances())};
    transparents.counts[0] += kPanes;
    std::vector<shared::Card> panes(kPanes);
    for (shared::Card& pane : panes) pane.optical_depth = 1.0f;
    SeenCards seen(device);
    seen.fit(transparents);
    gpu::Frame frame(device, pipelines);
    frame.pass("cards", [&](gpu::Pass& pass) {
      pass.update(cards, std::span<const shared::Card>(panes));
      pass.barrier();  // other cards of the same buffer: the validation layer cannot tell
      simulation.record_cards(pass, view, cards, kPanes, lighting.bodies());
    });
    seen.record(frame, transparents, submission);
    lighting.record(frame, transparents, kPanes);
    if (after) after(frame, view, lighting);
    Lit lit;
    for (const gpu::PassTime& pass : frame.finish())
      if (pass.name != "seen cards") lit.passes.push_back(pass.name);
    lit.cards = gpu::read<shared::Card>(device, cards);
    for (uint32_t i = 0; i < kPanes; ++i)
      EXPECT_EQ(0, std::memcmp(&panes[i], &lit.cards[i], sizeof(shared::Card))) << "no body, no light";
    lit.cards.erase(lit.cards.begin(), lit.cards.begin() + kPanes);
    if (!lighting.bodies()) return lit;
    lit.bodies = gpu::read<shared::LitBody>(device, *lighting.bodies());
    lit.bodies.resize(simulation.cards());
    lit.grids = gpu::read<shared::LightGrid>(device, lighting.grids());
    lit.sun = gpu::read_bytes(device, lighting.volume(0));
    lit.sky = gpu::read_bytes(device, lighting.volume(1));
    const auto words = gpu::read<uint32_t>(device, lighting.fire_lights());
    lit.fires.resize(words[0]);
    std::memcpy(lit.fires.data(), &words[1], lit.fires.size() * sizeof(shared::FireLight));
    return lit;
  }

  static constexpr uint32_t kPanes = 3;  ///< cards without a body, before those with one
  Scene scene;
};

double share_below(double x) {
  const double t = std::clamp(x * 0.5 + 0.5, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

dvec3 in_frame(const shared::LightGrid& grid, glm::vec3 p) {
  return {glm::dot(dvec3(p), dvec3(grid.axis_s)), glm::dot(dvec3(p), dvec3(grid.axis_t)),
          glm::dot(dvec3(p), dvec3(grid.axis_l))};
}

/// Optical depth of the body times the area that it is spread over, and the half widths of that.
struct Spread {
  dvec3 half_m;
  double cross_section;
};
Spread spread_of(const shared::LightGrid& grid, const shared::LitBody& body) {
  const dvec3 half = glm::max(dvec3(body.radius), 0.5 * dvec3(grid.cell));
  const double area = M_PI * half.x * half.y, part = std::min(M_PI * body.radius * body.radius / area, 1.0);
  return {half, -area * std::log(1 - part * (1 - std::exp(-double(body.depth))))};
}

std::vector<Emitter> cloud(uint32_t count, float least_radius = 0.2f, float most_radius = 0.9f) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> place(-1.5f, 1.5f), radius(least_radius, most_radius),
      tau(0.05f, 2.0f);
  std::vector<Emitter> emitters;
  for (uint32_t i = 0; i < count; ++i) {
    Emitter e;
    const float r = radius(random);
    e.name = "puff " + std::to_string(i);
    e.spawn.bursts = {{0, 1}};
    e.spawn.life_ticks = {1000, 1000};
    e.shape.offset_m = {place(random), 2.0f + place(random), place(random)};
    e.look.radius_m = r;
    e.look.cross_section_m2 = tau(random) * float(M_PI) * r * r;
    e.look.color = glm::vec3(0.8f);
    emitters.push_back(e);
  }
  return emitters;
}

TEST_F(LightingTest, TheVolumeHoldsTheOpticalDepthOfTheCellsBeforeIt) {
  const Lit lit = light(cloud(30));
  for (uint32_t g = 0; g < 2; ++g) {
    const shared::LightGrid& grid = lit.grids[g];
    const uint32_t n = grid.cells;
    std::vector<double> cells(size_t(n) * n * n, 0.0), covered(cells);  // optical depth, number of bodies
    for (const shared::LitBody& body : lit.bodies) {
      const auto [half, cross_section] = spread_of(grid, body);
      const dvec3 at = in_frame(grid, body.position) - dvec3(grid.origin);
      std::array<std::vector<double>, 3> share;
      for (int axis = 0; axis < 3; ++axis)
        for (uint32_t i = 0; i < n; ++i)
          share[axis].push_back(share_below(((i + 1.0) * grid.cell[axis] - at[axis]) / half[axis]) -
                                share_below((double(i) * grid.cell[axis] - at[axis]) / half[axis]));
      for (uint32_t l = 0, i = 0; l < n; ++l)
        for (uint32_t t = 0; t < n; ++t)
          for (uint32_t s = 0; s < n; ++s, ++i) {
            const double part = share[0][s] * share[1][t] * share[2][l];
            cells[i] += cross_section / (double(grid.cell.x) * grid.cell.y) * part;
            covered[i] += part > 0;
          }
    }
    const auto* texels = reinterpret_cast<const uint32_t*>((g == 0 ? lit.sun : lit.sky).data());
    double greatest = 0;
    for (uint32_t ray = 0; ray < n * n; ++ray) {
      double depth = 0, roundings = 0;
      for (uint32_t l = 0; l < n; ++l) {
        const double found = glm::unpackHalf2x16(texels[l * n * n + ray]).x;
        // Half a unit a body and cell, a step of a half float (devices may cut), and floats in the cubics.
        const double allowed = 0.5 * kUnit * roundings + depth * (2 * kHalfStep + 2e-5) + 1e-6;
        ASSERT_NEAR(depth, found, allowed) << "grid " << g << " ray " << ray << " face " << l;
        greatest = std::max(greatest, depth);
        depth += cells[l * n * n + ray];
        roundings += covered[l * n * n + ray];
      }
    }
    EXPECT_GT(greatest, 1.0) << "the volume is hardly filled";
  }
}

TEST_F(LightingTest, APuffBehindAnotherAlongTheSunIsDarkerByItsTransmittance) {
  const glm::vec3 sun = scene.light.sun_direction, place{0, 2, 0};
  const float albedo = 1e-3f;  // hardly any scattered light
  const auto black = [&](Emitter e) {
    e.look.color = glm::vec3(albedo);
    return e;
  };
  const double full = 2.0 * albedo;  // of the sun's red
  for (const float tau : {0.1f, 0.5f, 1.5f}) {
    const float r = 0.5f;
    const Lit lit = light({black(puff(place, r, tau * float(M_PI) * r * r)), black(speck(place - 3.0f * sun)),
                           black(speck(place + 3.0f * sun)), black(speck({2, 2, 0}))});
    const auto sunlit = [&](size_t i) { return rgb(lit.cards[i].sunlit).r; };
    EXPECT_NEAR(full, sunlit(2), full * kNothing) << "before the puff";
    EXPECT_NEAR(full, sunlit(3), full * kNothing) << "beside it";
    // In the middle of a ball's product kernel: C (3 / (4 r))^2. Cells a third of the radius wide flatten it.
    const double expected = tau * M_PI * 0.75 * 0.75;
    EXPECT_NEAR(expected, -std::log(sunlit(1) / full), 0.12 * expected) << "tau " << tau;
    EXPECT_NEAR(full, sunlit(0), full * 0.01) << "the puff shadows itself";
  }
}

TEST_F(LightingTest, AFireFallsOffWithTheSquareOfTheDistance) {
  scene.light.sun_color = glm::vec3(0.0f);
  scene.light.zenith = scene.light.horizon = glm::vec3(0.0f);
  const float r = 0.2f;
  const glm::vec3 radiance{3.0f, 2.0f, 1.0f};
  std::vector<Emitter> emitters{ember({0, 2, 0}, r, radiance)};
  const std::vector<double> distances{0.5, 1, 2, 4, 8};
  for (const double d : distances) emitters.push_back(speck({float(d), 2, 0}));
  const Lit lit = light(emitters);
  ASSERT_EQ(1u, lit.fires.size());
  EXPECT_NEAR(r, lit.fires[0].radius, 1e-4);
  for (size_t i = 0; i < distances.size(); ++i) {
    const double d = distances[i];
    for (int c = 0; c < 3; ++c) {
      const double expected = double(radiance[c]) * r * r / (d * d + r * r);
      EXPECT_NEAR(expected, rgb(lit.cards[i + 1].sunlit)[c], expected * kNothing) << d << " m";
    }
  }
}

TEST_F(LightingTest, AFireIsTheMeanOfItsParticlesAndAbsorbsWhatItHides) {
  // Two embers of unequal power.
  Lit lit = light({ember({-1, 2, 0}, 0.2f, glm::vec3(1.0f)), ember({1, 2, 0}, 0.2f, glm::vec3(3.0f))});
  ASSERT_EQ(1u, lit.fires.size());
  EXPECT_NEAR(0.5, lit.fires[0].position.x, 1e-5);
  EXPECT_NEAR(4 * 0.04, lit.fires[0].power.r, 1e-5);
  EXPECT_NEAR(5.0 / 3 * 0.75 + 0.04, lit.fires[0].radius_squared, 1e-4);
  // Many thick ones in one place shine like one: radiance does not add up behind what hides it.
  std::vector<Emitter> thick;
  for (int i = 0; i < 50; ++i) {
    thick.push_back(puff({0, 2, 0.001f * float(i)}, 0.5f, 5.0f));
    thick.back().look.emission = glm::vec3(2.0f);
  }
  lit = light(thick);
  ASSERT_EQ(1u, lit.fires.size());
  EXPECT_NEAR(2.0, lit.fires[0].power.r / lit.fires[0].radius_squared, 0.01);
}

TEST_F(LightingTest, PuffsOfNoSizeSpoilNothing) {
  Emitter unborn = puff({0, 2, 0}, 0.5f, 1.0f);
  unborn.look.radius_m = Curve({{0.0f, 0.0f}, {1.0f, 0.5f}});
  unborn.look.fade = 0.0f;
  unborn.look.emission = glm::vec3(1.0f);
  Emitter dense = unborn;
  dense.name = "dense";
  dense.look.fade = 1.0f;
  const Lit lit = light({unborn, dense, puff({0, 2, 0.3f}, 0.5f, 0.5f), ember({1, 2, 0}, 0.2f, {1, 1, 1})});
  ASSERT_EQ(1u, lit.fires.size());
  EXPECT_NEAR(0.04, lit.fires[0].power.r, 1e-4);
  for (size_t i = 0; i < lit.sun.size() / 2; ++i)
    ASSERT_LE(glm::unpackHalf1x16(reinterpret_cast<const uint16_t*>(lit.sun.data())[i]), 10.0f);
  for (const shared::Card& card : lit.cards)
    for (const glm::uvec2& half4 : {card.sunlit, card.ambient})
      for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(rgb(half4)[c]));
}

TEST_F(LightingTest, NoLightIsMade) {
  // Nothing is brighter than in the open: what is scattered was taken from what came directly.
  const Lit lit = light(cloud(60, 0.3f, 0.6f));
  const Lit open = light(cloud(60, 0.3f, 0.6f), {.self_shadow = false, .fire_gain = 0});
  ASSERT_FALSE(lit.bodies.empty());
  ASSERT_TRUE(open.bodies.empty());
  double darkest = 1;
  for (size_t i = 0; i < lit.cards.size(); ++i) {
    const dvec3 directed = rgb(lit.cards[i].sunlit), around = rgb(lit.cards[i].ambient);
    const dvec3 all_directed = rgb(open.cards[i].sunlit), all_around = rgb(open.cards[i].ambient);
    for (int c = 0; c < 3; ++c) {
      EXPECT_LE(directed[c], all_directed[c] * (1 + kNothing));
      EXPECT_LE(around[c], all_around[c] * (1 + kNothing));
    }
    darkest = std::min(darkest, directed.r / all_directed.r);
  }
  EXPECT_LT(darkest, 0.6) << "nothing was in the shadow";
}

TEST_F(LightingTest, EveryRoadToATickGivesTheSameBits) {
  std::vector<Emitter> emitters;
  for (const char* id : {"smoke_grenade", "fireball"})
    for (const Emitter& e : library.effect(id).emitters)
      if (e.look.meshes.empty()) emitters.push_back(e), emitters.back().name += id;
  const Lit sought = light(emitters, {}, 45), again = light(emitters, {}, 45),
            stepped = light(emitters, {}, 45, {}, true);
  const auto same = [](const auto& a, const auto& b) {
    return a.size() == b.size() &&
           std::ranges::equal(std::as_bytes(std::span(a)), std::as_bytes(std::span(b)));
  };
  for (const Lit* other : {&again, &stepped}) {
    EXPECT_TRUE(same(sought.cards, other->cards));
    EXPECT_TRUE(same(sought.sun, other->sun));
    EXPECT_TRUE(same(sought.fires, other->fires));
  }
  // Light does not depend on the camera, also where it turns its back.
  const Lit from_behind = light(emitters, {}, 45, CameraKey{.position = {0, 1, -9}, .target = {5, 1, -20}});
  EXPECT_TRUE(same(sought.bodies, from_behind.bodies));
  EXPECT_TRUE(same(sought.sun, from_behind.sun));
  EXPECT_TRUE(same(sought.sky, from_behind.sky));
  EXPECT_TRUE(same(sought.fires, from_behind.fires));
  EXPECT_FALSE(same(sought.cards, from_behind.cards));
}

TEST_F(LightingTest, CellsGrowEvenlyWithTheCloud) {
  // A step of the grid's size would be seen: all of the cloud would change its light at once.
  const std::vector<Emitter> smoke = library.effect("smoke_grenade").emitters;
  Lit before = light(smoke, {}, 60);
  for (uint32_t tick = 66; tick < 180; tick += 6) {
    const Lit now = light(smoke, {}, tick);
    for (uint32_t g = 0; g < shared::kLightGrids; ++g) {
      const glm::vec3 change = now.grids[g].cell / before.grids[g].cell - 1.0f;
      const glm::vec3 shift = (now.grids[g].origin - before.grids[g].origin) / now.grids[g].cell;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_LT(std::abs(change[axis]), 0.15f) << "tick " << tick;
        EXPECT_LT(std::abs(shift[axis]), 1.0f) << "tick " << tick;
      }
    }
    before = now;
  }
}

TEST_F(LightingTest, MoreFiresThanThereAreLightsShareThem) {
  for (const auto& [instances, lights] : {std::pair(0u, 0u), {3u, 3u}, {12u, shared::kMostFires}}) {
    Scene fires;
    fires.camera = {{.position = {60, 0, 200}, .target = {60, 0, 0}}};  // all are seen
    for (uint32_t i = 0; i < instances; ++i) {
      fires.instances.push_back(
          {.name = std::to_string(i), .effect = "sparks", .effect_at = {}, .call_tick = 0});
      fires.instances.back().position = {0.05f * float(i * i), 0, 0};  // all within sight
    }
    Stage stage(device, pipelines, library, fires);
    stage.go_to(20, {16, 16});
    EXPECT_EQ(lights, stage.lighting().fires()) << instances << " instances";
  }
}

TEST_F(LightingTest, WhatNothingCallsForHasNoPassesAndNoBytes) {
  const auto light_bytes = [&] { return device.memory().owner_bytes("light"); };
  EXPECT_EQ(std::vector<std::string>{"cards"}, light({speck({0, 1, 0})}).passes) << "casts nothing";
  Emitter flat = puff({0, 1, 0}, 1.0f, 1.0f);
  flat.look.lit = false;
  EXPECT_EQ(std::vector<std::string>{"cards"}, light({flat}).passes);
  EXPECT_EQ((std::vector<std::string>{"cards", "extinction", "light"}),
            light({puff({0, 1, 0}, 1, 1)}).passes);
  EXPECT_EQ((std::vector<std::string>{"cards", "light"}), light({ember({0, 1, 0}, 1, {1, 1, 1})}).passes);
  EXPECT_EQ(std::vector<std::string>{"cards"},
            light({ember({0, 1, 0}, 1, {1, 1, 1})}, {.fire_gain = 0}).passes)
      << "fires are no lights";

  Scene smoke = library.scene("grenade");
  Stage stage(device, pipelines, library, smoke);
  EXPECT_EQ(0u, light_bytes());
  stage.go_to(100, {16, 16});
  EXPECT_GT(light_bytes(), 48u * 48 * 48 * 4);
  stage.go_to(4000, {16, 16});
  EXPECT_EQ(0u, light_bytes()) << "the smoke is gone";
  smoke.light.self_shadow = false;
  Stage plain(device, pipelines, library, smoke);
  plain.go_to(100, {16, 16});
  EXPECT_EQ(0u, light_bytes()) << "the scene does not ask for it";
}

TEST_F(LightingTest, SmokeDarkensTheGroundBehindItAndAFireLightsIt) {
  scene.light.zenith = scene.light.horizon = glm::vec3(0.0f);
  const glm::vec3 sun = scene.light.sun_direction;
  // Seen from 10 m above: a pixel is 1 m wide, and the middle one lies half a metre from the axis both ways.
  const CameraKey above{.position = {0, 10, 0}, .target = {0, 0, 0}, .vertical_fov_deg = 77.3196f};
  const auto ground = [&](const std::vector<Emitter>& emitters) {
    const OpaqueScene plane(device,
                            {{.kind = SolidKind::kPlane, .color = glm::vec3(0.5f), .size_m = {100, 0, 100}}});
    const Targets targets(device, {16, 16});
    light(emitters, {}, 0, above, false,
          [&](gpu::Frame& frame, const gpu::Buffer& view, const Lighting& lighting) {
            plane.record_depth(frame, targets, view);
            plane.record_color(frame, targets, targets.opaque_depth, view, &lighting);
          });
    return glm::dvec3(glm::unpackHalf4x16(gpu::read<uint64_t>(device, targets.opaque_color)[8 * 16 + 8]));
  };
  const glm::vec3 here{0.5f, 0.0f, 0.5f};
  const dvec3 open = ground({speck({50, 1, 50})});
  EXPECT_NEAR(0.5 * 2.0 * sun.y, open.r, 0.002);
  const float r = 1.0f, tau = 1.0f;
  const dvec3 shadowed = ground({puff(here + 4.0f * sun, r, tau * float(M_PI) * r * r)});
  const double expected = tau * M_PI * 0.75 * 0.75;
  EXPECT_NEAR(expected, -std::log(shadowed.r / open.r), 0.12 * expected);

  scene.light.sun_color = glm::vec3(0.0f);
  const glm::vec3 fire{2.0f, 1.5f, -1.0f}, arm = fire - here;
  const dvec3 lit = ground({ember(fire, 0.3f, {6, 3, 1})});
  const double squared = glm::dot(arm, arm), facing = arm.y / std::sqrt(squared);
  for (int c = 0; c < 3; ++c) {
    const double light = 0.5 * std::array{6.0, 3.0, 1.0}[c] * 0.09 / (squared + 0.09) * facing;
    EXPECT_NEAR(light, lit[c], 0.01 * light);
  }
}

}  // namespace
}  // namespace plume
