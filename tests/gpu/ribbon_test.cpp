// Ribbons: what is drawn is the band that consecutive births span, without gaps and without overlaps.
#include <cmath>
#include <glm/gtc/packing.hpp>

#include "tests/gpu/particle_looks.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{160, 90};
constexpr float kFov = 50, kDistance = 8;
const double kPixelsAMetre = kSize.y / 2.0 / std::tan(glm::radians(kFov / 2.0)) / double(kDistance);

class Ribbon : public PresetFolderTest {
 protected:
  static Scene scene() {
    Scene scene;
    scene.light.sky = false;
    scene.light.horizon = {0.2f, 0.3f, 0.5f};
    scene.tonemap = Tonemap::kNone;
    scene.camera = {
        {.tick = 0, .position = {0, 0, kDistance}, .target = {0, 0, 0}, .vertical_fov_deg = kFov}};
    return scene;
  }
  static glm::vec3 covered(float opacity) {
    return glm::mix(scene().light.horizon, glm::vec3(0.8f, 0.4f, 0.1f), opacity);
  }
  /// A birth a tick from tick 0; each is where its age says, so that the ribbon is their path.
  std::vector<glm::vec3> draw_ribbon(uint32_t tick, glm::vec3 from, const std::string& motion,
                                     const std::string& radius) {
    write("effects/ribbon.toml",
          "name = 'R'\n[[emitter]]\nname = 'r'\nspawn = {rate = 60, duration = 600, life = 600}\n"
          "motion = {" +
              motion +
              "}\n[emitter.look]\nribbon = true\ntexture = 'solid'\nlit = false\n"
              "opacity = 0.5\ncolor = [0.8, 0.4, 0.1]\nradius_m = " +
              radius + "\n");
    Scene with = scene();
    with.instances = {{.name = "r", .effect = "ribbon", .call_tick = 0, .position = from}};
    Stage stage(device, pipelines, PresetLibrary(root_), with);
    return draw(stage, tick, kSize, "reference").linear.pixels;
  }
  /// Pixels that a half-covering band covers once; any other value than that or the background fails.
  static size_t expect_once_or_nothing(const std::vector<glm::vec3>& pixels) {
    size_t once = 0;
    for (size_t i = 0; i < pixels.size(); ++i) {
      const bool is_covered = glm::length(pixels[i] - covered(0.5f)) < 2e-3f;
      once += is_covered;
      EXPECT_TRUE(is_covered || glm::length(pixels[i] - scene().light.horizon) < 2e-3f)
          << "pixel " << i % kSize.x << ", " << i / kSize.x;
    }
    return once;
  }
};

TEST_F(Ribbon, AStraightOneIsOneLongPane) {
  constexpr uint32_t kTick = 120;
  const auto ribbon = draw_ribbon(kTick, {-2.013f, 0.021f, 0}, "velocity = [2, 0, 0]", "0.4");
  Scene with = scene();
  // Births of ticks 0 .. kTick, the oldest of which has moved for kTick ticks.
  with.panes = {{.position = {-2.013f + 2.0f * kTick / 60 / 2, 0.021f, 0},
                 .size_m = {2.0f * kTick / 60, 0.8f},
                 .color = {0.8f, 0.4f, 0.1f},
                 .coverage = 0.5f}};
  Stage stage(device, pipelines, library, with);
  const auto pane = draw(stage, 0, kSize, "reference").linear.pixels;
  for (size_t i = 0; i < pane.size(); ++i)
    ASSERT_LT(glm::length(pane[i] - ribbon[i]), 2e-3f) << "pixel " << i % kSize.x << ", " << i / kSize.x;
  EXPECT_GT(expect_once_or_nothing(ribbon), 400u);
}

TEST_F(Ribbon, ABentOneHasNeitherGapsNorOverlapsAndTheWidthItAsksFor) {
  // A throw: a parabola across the picture. Its band's area is the width times the length.
  constexpr uint32_t kTick = 110;
  const double speed_x = 2.3, speed_y = 9, gravity = 9.81;
  const auto pixels = draw_ribbon(kTick, {-2.1f, -2.0f, 0}, "velocity = [2.3, 9, 0], gravity = 1", "0.2");
  double length = 0;
  for (uint32_t t = 0; t < kTick; ++t) length += std::hypot(speed_x, speed_y - gravity * (t + 1) / 60) / 60;
  const double expected = length * 0.4 * kPixelsAMetre * kPixelsAMetre;
  EXPECT_NEAR(1.0, double(expect_once_or_nothing(pixels)) / expected, 0.03);
}

TEST_F(Ribbon, ItsWidthIsTwiceTheRadiusAtEachBirthsAge) {
  const auto pixels = draw_ribbon(120, {-2, 0, 0}, "velocity = [2, 0, 0]", "[[0, 0.1], [0.2, 0.9]]");
  size_t compared = 0;
  for (uint32_t x = 0; x < kSize.x; ++x) {
    const double place = (x + 0.5 - kSize.x / 2.0) / kPixelsAMetre;  // metres
    const double share = (place + 2) / 2 * 60 / 120;                 // of the births' ages up to 120 ticks
    if (share < 0.02 || share > 0.98) continue;
    size_t rows = 0;
    for (uint32_t y = 0; y < kSize.y; ++y)
      rows += glm::length(pixels[y * kSize.x + x] - covered(0.5f)) < 2e-3f;
    EXPECT_NEAR(2 * (0.1 + 0.8 * share) * kPixelsAMetre, double(rows), 1.5) << "column " << x;
    ++compared;
  }
  EXPECT_GT(compared, 40u);
}

class RibbonCards : public ParticleCards {
 protected:
  static Effect effect() {
    Effect effect{.id = "test", .name = "", .description = "", .emitters = {Emitter()}};
    Emitter& e = effect.emitters[0];
    e.name = "test";
    e.spawn.rate = {{0, 60.0}, {100, 60.0}};
    e.spawn.life_ticks = {50, 50};
    e.look.opacity = Curve(0.5f);
    e.look.radius_m = Curve(0.1f);
    e.look.ribbon = true;
    e.motion.velocity = {1, 0, 0};
    return effect;
  }
  size_t shown(const Effect& effect, uint32_t tick) {
    const auto cards = cards_of(simulate(effect, tick));
    return size_t(std::ranges::count_if(cards, [](const auto& card) { return card.optical_depth > 0; }));
  }
};

TEST_F(RibbonCards, SegmentsAreTwoTrianglesBetweenTheLivingOfOneRibbon) {
  Effect line = effect();
  EXPECT_EQ(2u * 20, shown(line, 20)) << "21 births";
  EXPECT_EQ(2u * 49, shown(line, 70)) << "50 alive";
  line.emitters[0].look.ribbon_births = 10;
  EXPECT_EQ(2u * 18, shown(line, 20)) << "ribbons of 10, 10 and 1";
}

TEST_F(RibbonCards, WhatHasNoLengthGivesNothing) {
  Effect still = effect();
  still.emitters[0].motion.velocity = {0, 0, 0};
  EXPECT_EQ(0u, shown(still, 20));
}

/// Half widths from a joint to the left corners of a segment's ends.
std::pair<glm::dvec3, glm::dvec3> to_left(const std::vector<shared::Card>& cards,
                                          const std::vector<shared::Particle>& particles, size_t segment,
                                          const std::array<glm::dvec3, 3>& first_half) {
  EXPECT_GT(cards[2 * segment].optical_depth, 0.0f);
  return {first_half[0] - glm::dvec3(particles[segment].position),
          first_half[1] - glm::dvec3(particles[segment + 1].position)};
}

TEST_F(RibbonCards, JointsAreMitredSoThatBothSegmentsKeepTheirWidth) {
  Effect bent = effect();
  Emitter& e = bent.emitters[0];
  e.spawn.rate = {{0, 6.0}, {120, 6.0}};  // far apart: bends of up to 40 degrees
  e.spawn.life_ticks = {200, 200};
  e.motion.velocity = {1, 4, 0.3f};
  e.motion.gravity = 1;
  e.look.ribbon_births = 5;
  const Simulation simulation = simulate(bent, 100);
  const auto particles = simulation.particles();
  const auto cards = cards_of(simulation);
  ASSERT_GT(particles.size(), 8u);
  const glm::dvec3 camera(0, 1, 10);
  size_t bends = 0, ends = 0;
  for (size_t i = 0; i + 1 < particles.size(); ++i) {
    if ((i + 1) % 5 == 0) continue;  // between two ribbons
    const auto [from, to] = to_left(cards, particles, i, corners(cards[2 * i]));
    const glm::dvec3 a(particles[i].position), b(particles[i + 1].position);
    const auto across = [&](glm::dvec3 eye) { return glm::normalize(glm::cross(b - a, eye)); };
    EXPECT_NEAR(0.1, std::abs(glm::dot(from, across(camera - a))), 2e-6) << "segment " << i;
    EXPECT_NEAR(0.1, std::abs(glm::dot(to, across(camera - b))), 2e-6) << "segment " << i;
    for (const auto& [arm, end] : {std::pair(from, i % 5 == 0), std::pair(to, (i + 2) % 5 == 0)}) {
      ++(end ? ends : bends);
      if (end) {
        EXPECT_NEAR(0.1, glm::length(arm), 2e-6) << "square, at segment " << i;
      }
    }
  }
  EXPECT_GT(bends, 5u);
  EXPECT_GE(ends, 3u);
}

TEST_F(RibbonCards, SharpBendsAreNoWiderThanTheLongestMitre) {
  // Thrown up and falling back, with hardly any way sideways: it turns within a few births.
  Effect thrown = effect();
  thrown.emitters[0].motion.gravity = 1;
  double widest = 0;
  for (const float sideways : {0.02f, 0.01f, 0.001f, 0.0f}) {
    thrown.emitters[0].motion.velocity = {sideways, 2, 0};
    const Simulation simulation = simulate(thrown, 45);
    const auto particles = simulation.particles();
    const auto cards = cards_of(simulation);
    for (size_t i = 0; i + 1 < particles.size(); ++i) {
      if (cards[2 * i].optical_depth == 0) continue;
      const auto [from, to] = to_left(cards, particles, i, corners(cards[2 * i]));
      for (const glm::dvec3& arm : {from, to}) {
        ASSERT_TRUE(std::isfinite(arm.x + arm.y + arm.z));
        EXPECT_LT(glm::length(arm), 0.1 * 2.5 + 1e-5);
        widest = std::max(widest, glm::length(arm));
      }
    }
  }
  EXPECT_GT(widest, 0.2) << "no bend was sharp";
}

TEST_F(RibbonCards, TheSegmentsThatMeetShareTheirCorners) {
  Effect bent = effect();
  bent.emitters[0].motion.velocity = {1, 3, 0.5f};
  bent.emitters[0].motion.gravity = 1;
  const auto cards = cards_of(simulate(bent, 40));
  for (size_t i = 0; i + 3 < 2 * 40; i += 2) {
    // Corners: left and right at one end, left at the other; then the two rights and a left.
    const Triangle first = corners(cards[i]), second = corners(cards[i + 1]), next = corners(cards[i + 2]);
    EXPECT_LT(glm::length(first[1] - next[0]), 1e-6) << "left";
    EXPECT_LT(glm::length(second[0] - next[2]), 1e-6) << "right";
    EXPECT_LT(glm::length(first[2] - second[1]) + glm::length(first[1] - second[2]), 1e-6) << "the diagonal";
  }
}

/// The points that a segment's middle runs between.
std::pair<glm::dvec3, glm::dvec3> ends(const std::array<glm::dvec3, 3>& first_half,
                                       const std::array<glm::dvec3, 3>& second_half) {
  return {0.5 * (first_half[0] + first_half[2]), 0.5 * (first_half[1] + second_half[0])};
}

TEST_F(RibbonCards, ATrailOfChildrenRunsFromTheOldestToItsParent) {
  Effect trails = effect();
  Emitter& parent = trails.emitters[0];
  parent.name = "head";
  parent.spawn = {.rate = {}, .bursts = {{0, 3}}, .life_ticks = {40, 40}};
  parent.motion.velocity = {};
  parent.motion.speed = {2, 3};
  parent.motion.gravity = 1;
  parent.look.ribbon = false;
  Emitter trail = effect().emitters[0];
  trail.name = "trail";
  trail.spawn = {.rate = {}, .life_ticks = {100, 100}};
  trail.motion.velocity = {};
  trail.parent = Parent{.emitter = "head", .index = 0, .event = BirthEvent::kLife, .every_ticks = 5};
  trails.emitters.push_back(trail);
  // Siblings are born at ages 0, 5 .. 35 and as the parent dies; until then it is the head.
  for (const auto& [tick, segments] : {std::pair(23u, 5u), {38u, 8u}, {60u, 8u}}) {
    const Simulation simulation = simulate(trails, tick);
    const auto particles = simulation.particles();
    const auto cards = cards_of(simulation);
    const size_t parents = tick < 40 ? 3 : 0;
    ASSERT_EQ(parents + 3 * 9, particles.size()) << "tick " << tick;
    for (size_t strand = 0; strand < 3; ++strand) {
      size_t shown = 0;
      glm::dvec3 until(particles[parents + 9 * strand].position);
      for (size_t i = parents + 18 * strand; i < parents + 18 * (strand + 1); i += 2) {
        if (cards[i].optical_depth == 0) continue;
        const auto [from, to] = ends(corners(cards[i]), corners(cards[i + 1]));
        EXPECT_LT(glm::length(from - until), 2e-6) << "a gap, tick " << tick;
        until = to;
        ++shown;
      }
      EXPECT_EQ(segments, shown) << "tick " << tick;
      if (parents > 0) {
        EXPECT_LT(glm::length(until - glm::dvec3(particles[strand].position)), 2e-6) << "tick " << tick;
      }
    }
  }
}

TEST_F(RibbonCards, AFlipbookOverLifeHasRunItsLoopsWhenLifeIsOver) {
  Effect puff = effect();
  Emitter& e = puff.emitters[0];
  e.spawn = {.rate = {}, .bursts = {{0, 20}}, .life_ticks = {120, 120}};
  e.look.ribbon = false;
  e.look.flipbook_fps = 0;
  e.look.flipbook_loops = 2;  // 24 frames in 120 ticks
  const auto frame_of = [](const shared::Card& card) {
    return double((card.layers & 0xfffu) % 12) + double(glm::unpackHalf2x16(card.sunlit.y).y);
  };
  const auto first = cards_of(simulate(puff, 0));
  for (const auto& [tick, frames] : {std::pair(5u, 1.0), {30u, 6.0}, {60u, 12.0}, {113u, 22.6}}) {
    const auto later = cards_of(simulate(puff, tick));
    for (size_t i = 0; i < first.size(); ++i) {
      const double on = frame_of(later[i]) - frame_of(first[i]) - frames;
      EXPECT_NEAR(0, on - 12 * std::round(on / 12), 2e-3) << "tick " << tick;
    }
  }
}

}  // namespace
}  // namespace plume
