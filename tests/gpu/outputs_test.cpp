// Distortion, depth and motion of the transparent image against models on the CPU, and what is done with
// them.
#include <cmath>
#include <glm/gtc/packing.hpp>
#include <set>

#include "renderer/seen_cards.h"
#include "sandbox/scene/opaque.h"
#include "sandbox/scene/view.h"
#include "shaders/effects/puff.h"
#include "shaders/shared/card.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{64, 48};
constexpr float kFov = 60.0f, kWall = 10.0f;
const double kTan = std::tan(glm::radians(double(kFov)) / 2);
const double kPixelsARadian = kSize.y / 2.0 / kTan;

using Texels = std::vector<glm::vec4>;

/// Cards of the test's own, all of one density and one slope, before a wall of stripes ten metres away.
class OutputsTest : public GpuTest {
 protected:
  struct Cards {
    std::vector<shared::Card> scalar, haze;
  };
  struct Drawn {
    std::vector<glm::vec3> picture;
    Texels distortion, surface;
    FrameReport report;
  };

  static CameraKey camera(glm::vec3 position = {0, 0, 0}) {
    return {
        .tick = 0, .position = position, .target = position - glm::vec3(0, 0, 1), .vertical_fov_deg = kFov};
  }
  /// A square that faces the camera.
  static shared::Card card(float z, float half, float alpha) {
    shared::Card c{};
    c.center = {0, 0, -z};
    c.axis_u = {half, 0, 0};
    c.axis_v = {0, half, 0};
    c.optical_depth = alpha < 1 ? -std::log1p(-alpha) : 64.0f;
    c.ambient = {glm::packHalf2x16({0.9f, 0.2f}), glm::packHalf2x16({0.1f, 0})};
    return c;
  }
  static shared::Card moving(shared::Card c, glm::vec3 motion) {
    c.motion = {glm::packHalf2x16({motion.x, motion.y}), glm::packHalf2x16({motion.z, 0})};
    return c;
  }
  static shared::Card haze(float z, float half, float bend) {
    shared::Card c = card(z, half, 0);
    c.motion = {0, glm::packHalf2x16({0, bend})};
    return c;
  }
  static std::vector<Solid> striped_wall() {
    std::vector<Solid> stripes;
    for (int i = -16; i < 16; ++i) {
      Solid s;
      s.material = Material::kUnlit;
      s.color = {i % 2 ? 0.8f : 0.1f, float(i + 16) / 32, i % 3 ? 0.3f : 0.6f};
      s.position = {float(i) + 0.5f, 0, -kWall - 0.5f};
      s.size_m = {1, 40, 1};
      stripes.push_back(s);
    }
    return stripes;
  }

  Drawn draw_cards(std::string_view id, const Cards& cards, const Post& post,
                   std::vector<Solid> solids = striped_wall(),
                   const std::optional<CameraKey>& previous = {}) {
    Scene scene;
    scene.light.sky = false;
    scene.tonemap = Tonemap::kNone;
    scene.solids = std::move(solids);
    std::vector<shared::Card> all = cards.scalar;
    all.insert(all.end(), cards.haze.begin(), cards.haze.end());
    std::vector<uint32_t> order(std::max<size_t>(all.size(), 1));
    for (uint32_t i = 0; i < order.size(); ++i) order[i] = i;
    if (all.empty()) all.emplace_back();
    const auto card_buffer = gpu::make_buffer(device, "test", "cards", all);
    const auto order_buffer = gpu::make_buffer(device, "test", "order", order);
    const auto view =
        gpu::make_buffer(device, "test", "view", std::vector{make_view(scene, camera(), kSize, 1, previous)});
    const gpu::Image puffs(device, {.owner = "test",
                                    .label = "puffs",
                                    .format = vk::Format::eR8G8B8A8Unorm,
                                    .extent = {4, 4, 1},
                                    .layers = 1,
                                    .usage = vk::ImageUsageFlagBits::eSampled});
    const OpaqueScene opaque(device, scene.solids);
    Transparents transparents{.cards = &card_buffer,
                              .puffs = &puffs,
                              .view = &view,
                              .count = uint32_t(cards.scalar.size() + cards.haze.size()),
                              .counts = {uint32_t(cards.scalar.size()), uint32_t(cards.haze.size()), 0}};
    SeenCards seen(device);
    seen.fit(transparents);
    const Prelude prelude{
        .geometry =
            [&](gpu::Frame& frame, const Targets& targets) {
              frame.pass("puffs", [&](gpu::Pass& pass) {
                pass.clear(puffs, {1 / 3.0f, 1, 0.5f, 1});  // density 1, slope (1, 0)
              });
              seen.record(frame, transparents, order_buffer);
              opaque.record_depth(frame, targets, view);
            },
        .opaque = [&](gpu::Frame& frame, const Targets& targets,
                      const gpu::Image& depth) { opaque.record_color(frame, targets, depth, view); }};
    const Targets targets(device, kSize, post);
    MethodInstance method = instance(id);
    Drawn drawn{.report = render_frame(device, pipelines, targets, prelude, transparents, method)};
    drawn.picture = read_picture(device, targets).linear.pixels;
    if (targets.distortion) drawn.distortion = texels(targets.distortion);
    if (targets.surface) drawn.surface = texels(targets.surface);
    return drawn;
  }

  Texels texels(const gpu::Image& image) {
    Texels result;
    for (const uint64_t texel : gpu::read<uint64_t>(device, image))
      result.push_back(glm::unpackHalf4x16(texel));
    return result;
  }
  static size_t at(uint32_t x, uint32_t y) { return size_t(y) * kSize.x + x; }
  /// Pixels across which a half edge at depth z reaches from the middle.
  static double reach(double half, double z) { return half / z * kPixelsARadian; }
  static bool inside(uint32_t x, uint32_t y, double pixels) {
    return std::abs(x + 0.5 - kSize.x / 2.0) < pixels - 0.01 &&
           std::abs(y + 0.5 - kSize.y / 2.0) < pixels - 0.01;
  }
  static double shift_of(double bend, double z, double background) {
    return bend * kPixelsARadian * (1 - z / background);
  }
  static std::set<std::string> names(const FrameReport& report) {
    std::set<std::string> result;
    for (const gpu::PassTime& pass : report.passes) result.insert(pass.name);
    return result;
  }
  /// Weighted blending knows no transmittance between two fragments: its tests say what it writes instead.
  static bool guesses_transmittance(const std::string& id) {
    return make_method(id)->traits().emission.find("unattenuated") != std::string_view::npos;
  }
  static glm::vec3 middle(const Texels& t) { return glm::vec3(t[at(kSize.x / 2, kSize.y / 2)]); }
};

/// Every method that says it writes them.
class OutputsOf : public OutputsTest, public testing::WithParamInterface<std::string> {};
std::vector<std::string> writers() {
  std::vector<std::string> ids;
  for (const std::string& id : method_ids())
    if (const Outputs o = make_method(id)->outputs(); o.distortion && o.surface) ids.push_back(id);
  return ids;
}
INSTANTIATE_TEST_SUITE_P(All, OutputsOf, testing::ValuesIn(writers()),
                         [](const auto& id) { return id.param; });

TEST_P(OutputsOf, OneHazeCardBendsWhatIsBehindItByItsAngleAndDistance) {
  const float z = 4, half = 1.2f, bend = 0.1f;
  const Cards cards{.scalar = {}, .haze = {haze(z, half, bend)}};
  const auto straight = draw_cards(GetParam(), cards, {});
  const auto bent = draw_cards(GetParam(), cards, {.distortion = true, .lens = {}});
  EXPECT_TRUE(bent.report.left_out.empty());
  const double shift = shift_of(bend, z, kWall);
  ASSERT_GT(shift, 2.0);
  for (uint32_t y = 0; y < kSize.y; ++y)
    for (uint32_t x = 0; x < kSize.x; ++x) {
      const glm::vec4 d = bent.distortion[at(x, y)];
      if (!inside(x, y, reach(half, z))) {
        ASSERT_EQ(glm::vec4(0), d) << x << " " << y;
        ASSERT_EQ(straight.picture[at(x, y)], bent.picture[at(x, y)]);
        continue;
      }
      ASSERT_NEAR(shift, d.x, 0.01) << x << " " << y;
      ASSERT_NEAR(0, d.y, 0.02) << "the texture's 0.5 is 128/255";
      ASSERT_NEAR(1 / z, d.z / d.w, 1e-3);
      const double place = x + shift;
      const uint32_t left = uint32_t(place);
      if (left + 1 >= kSize.x) continue;
      const glm::vec3 expected =
          glm::mix(straight.picture[at(left, y)], straight.picture[at(left + 1, y)], float(place - left));
      ASSERT_LT(glm::length(expected - bent.picture[at(x, y)]), 0.02f) << x << " " << y;
    }
}

TEST_P(OutputsOf, HazeCountsAsFarAsWhatIsInFrontLetsItThrough) {
  if (guesses_transmittance(GetParam()))
    GTEST_SKIP() << "its weights are a guess of transmittance: there is no value to expect";
  const float bend = 0.1f;
  const auto seen = [&](float haze_z, float smoke_z, float alpha) {
    const auto drawn =
        draw_cards(GetParam(), {.scalar = {card(smoke_z, 20, alpha)}, .haze = {haze(haze_z, 3, bend)}},
                   {.distortion = true, .lens = {}});
    return middle(drawn.distortion).x / shift_of(bend, haze_z, kWall);
  };
  EXPECT_NEAR(0.0, seen(6, 4, 1.0f), 1e-4) << "opaque smoke in front";
  EXPECT_NEAR(1.0, seen(2, 4, 1.0f), 2e-3) << "opaque smoke behind";
  EXPECT_NEAR(0.4, seen(6, 4, 0.6f), 0.01) << "thin smoke in front";
  EXPECT_NEAR(1.0, seen(2, 4, 0.6f), 2e-3) << "thin smoke behind";
}

TEST_P(OutputsOf, OpaqueThingsInFrontOfTheHazeAreNotDragged) {
  auto solids = striped_wall();
  for (Solid& stripe : solids) stripe.color.r = 0;
  Solid pillar;
  pillar.material = Material::kUnlit;
  pillar.color = {1, 0, 0};
  pillar.position = {0, 0, -2};
  pillar.size_m = {0.4f, 9, 0.2f};
  solids.push_back(pillar);
  const Cards cards{.scalar = {}, .haze = {haze(4, 20, 0.15f)}};
  const auto straight = draw_cards(GetParam(), cards, {}, solids);
  const auto bent = draw_cards(GetParam(), cards, {.distortion = true, .lens = {}}, solids);
  size_t beside = 0;
  for (size_t i = 0; i < straight.picture.size(); ++i) {
    ASSERT_EQ(straight.picture[i].r, bent.picture[i].r) << "pixel " << i;
    beside += straight.picture[i] != bent.picture[i];
  }
  EXPECT_GT(beside, 200u) << "nothing is bent";
}

TEST_P(OutputsOf, DepthIsTheMeanOfWhatIsSeenAndItsWeightIsWhatCovers) {
  const Post post{.surface = true, .lens = {}};
  const glm::vec3 one =
      middle(draw_cards(GetParam(), {.scalar = {card(5, 20, 0.6f)}, .haze = {}}, post).surface);
  EXPECT_NEAR(0.6, one.y, 2e-3);
  EXPECT_NEAR(5.0, one.y / one.x, 0.01);
  const auto none = draw_cards(GetParam(), {.scalar = {card(12, 20, 0.5f)}, .haze = {}}, post);
  EXPECT_EQ(glm::vec3(0), middle(none.surface)) << "behind the wall";
  if (guesses_transmittance(GetParam())) return;
  const glm::vec3 two = middle(
      draw_cards(GetParam(), {.scalar = {card(8, 20, 0.5f), card(4, 20, 0.5f)}, .haze = {}}, post).surface);
  EXPECT_NEAR(0.75, two.y, 5e-3);
  EXPECT_NEAR(0.5 / 4 + 0.25 / 8, two.x, 2e-3);
}

TEST_P(OutputsOf, AGlowWithoutCoverageHasADepthToo) {
  shared::Card glow = card(5, 20, 0);
  glow.emission = {glm::packHalf2x16({2, 2}), glm::packHalf2x16({2, 0})};
  glow.layers = shared::kSoftLayer | shared::kSoftLayer << shared::kLayerBits;  // which glows as it says
  const glm::vec3 t =
      middle(draw_cards(GetParam(), {.scalar = {glow}, .haze = {}}, {.surface = true, .lens = {}}).surface);
  EXPECT_NEAR(2.0, t.y, 0.01);
  EXPECT_NEAR(5.0, t.y / t.x, 0.01);
}

TEST_P(OutputsOf, MotionIsThatOfTheProjectedPointAndOfTheCamera) {
  const glm::dvec3 moved(0.125, -0.0625, 0.25), camera_before(0.25, 0.125, -0.5);
  const double z = 5;
  for (const bool camera_moves : {false, true}) {
    const glm::dvec3 eye = camera_moves ? camera_before : glm::dvec3(0);
    const auto t = draw_cards(GetParam(), {.scalar = {moving(card(float(z), 20, 0.6f), moved)}, .haze = {}},
                              {.surface = true, .lens = {}}, striped_wall(), camera(glm::vec3(eye)))
                       .surface;
    for (const glm::uvec2 p : {glm::uvec2(3, 4), glm::uvec2(32, 24), glm::uvec2(60, 40)}) {
      const glm::dvec2 centre = glm::dvec2(p) + 0.5, middle_px = glm::dvec2(kSize) / 2.0;
      const glm::dvec2 across = (centre - middle_px) / kPixelsARadian * z;
      const glm::dvec3 before = glm::dvec3(across.x, -across.y, -z) - moved - eye;
      const glm::dvec2 came_from = middle_px + glm::dvec2(before.x, -before.y) / -before.z * kPixelsARadian;
      const glm::vec4 sum = t[at(p.x, p.y)];
      EXPECT_NEAR(centre.x - came_from.x, sum.z / sum.y, 0.02) << p.x << " camera " << camera_moves;
      EXPECT_NEAR(centre.y - came_from.y, sum.w / sum.y, 0.02) << p.y << " camera " << camera_moves;
    }
  }
}

TEST_P(OutputsOf, ALensLeavesWhatIsInFocusToTheBitAndBlursTheRest) {
  const Cards smoke{.scalar = {card(4, 1.2f, 1.0f)}, .haze = {}};
  const auto lens = [](float focus_m) { return Post{.lens = Lens{.focus_m = focus_m, .aperture_mm = 300}}; };
  const auto sharp = draw_cards(GetParam(), smoke, {});
  const auto on_wall = draw_cards(GetParam(), smoke, lens(kWall)),
             on_smoke = draw_cards(GetParam(), smoke, lens(4));
  const double circle = 0.5 * 0.3 * (1 / 4.0 - 1 / kWall) * kPixelsARadian;  // radius, pixels
  ASSERT_GT(circle, 0.7);
  size_t wall_blurred = 0, edge_blurred = 0;
  for (uint32_t y = 0; y < kSize.y; ++y)
    for (uint32_t x = 0; x < kSize.x; ++x) {
      const size_t i = at(x, y);
      if (inside(x, y, reach(1.2, 4))) {
        ASSERT_EQ(sharp.picture[i], on_smoke.picture[i]) << x << " " << y;
      } else if (!inside(x, y, reach(1.2, 4) + circle + 1)) {
        ASSERT_EQ(sharp.picture[i], on_wall.picture[i]) << x << " " << y;
        wall_blurred += sharp.picture[i] != on_smoke.picture[i];
      } else {
        edge_blurred += sharp.picture[i] != on_wall.picture[i];
      }
    }
  EXPECT_GT(wall_blurred, 100u);
  EXPECT_GT(edge_blurred, 20u);
}

TEST_F(OutputsTest, ALensSpreadsAPointOverTheDiscOfItsCircle) {
  Solid back, lamp;
  back.material = lamp.material = Material::kUnlit;
  back.color = glm::vec3(0);
  back.position = {0, 0, -kWall - 0.5f};
  back.size_m = {40, 40, 1};
  lamp.color = glm::vec3(1);
  lamp.position = {0, 0, -kWall};
  lamp.size_m = glm::vec3(0.6f);
  const float focus = 2, aperture_mm = 800;
  const Post post{.lens = Lens{.focus_m = focus, .aperture_mm = aperture_mm}};
  const auto sharp = draw_cards("reference", {}, {}, {back, lamp}),
             blurred = draw_cards("reference", {}, post, {back, lamp});
  double light = 0, spread = 0, farthest = 0;
  for (uint32_t y = 0; y < kSize.y; ++y)
    for (uint32_t x = 0; x < kSize.x; ++x) {
      light += sharp.picture[at(x, y)].r;
      spread += blurred.picture[at(x, y)].r;
      if (blurred.picture[at(x, y)].r > 0.004f)
        farthest = std::max(farthest, std::hypot(x + 0.5 - 32.0, y + 0.5 - 24.0));
    }
  const double circle = std::min(0.5 * aperture_mm * 1e-3 * (1 / focus - 1 / 9.7) * kPixelsARadian, 8.0);
  EXPECT_NEAR(light, spread, 0.15 * light) << "light is lost or made";
  EXPECT_NEAR(circle + 1, farthest, 1.0) << "circle " << circle;
}

TEST_F(OutputsTest, ANearEdgeIsHalfThereAtItsOutlineAndGoneACircleAway) {
  Solid back;
  back.material = Material::kUnlit;
  back.color = glm::vec3(0);
  back.position = {0, 0, -kWall - 0.5f};
  back.size_m = {40, 40, 1};
  const Cards near{.scalar = {card(2, 0.7f, 1.0f)}, .haze = {}};
  const float aperture_mm = 700;
  const auto drawn =
      draw_cards("reference", near, {.lens = Lens{.focus_m = kWall, .aperture_mm = aperture_mm}}, {back});
  const double outline = reach(0.7, 2),
               circle = 0.5 * aperture_mm * 1e-3 * (1 / 2.0 - 1 / kWall) * kPixelsARadian;
  ASSERT_GT(circle, 5.0);
  ASSERT_LT(circle, 8.0);
  for (uint32_t x = kSize.x / 2; x < kSize.x; ++x) {
    const double beyond =
        x + 0.5 - kSize.x / 2.0 - outline;  // share of a disc on the card's side of its edge
    const double d = std::clamp(beyond / circle, -1.0, 1.0);
    const double share = 0.5 - (d * std::sqrt(1 - d * d) + std::asin(d)) / M_PI;
    EXPECT_NEAR(share, drawn.picture[at(x, kSize.y / 2)].r / 0.9, 0.12) << beyond << " pixels beyond";
  }
}

TEST_F(OutputsTest, WhatIsNotWantedOrNotThereCostsNoPass) {
  const Cards smoke{.scalar = {card(4, 2, 0.5f)}, .haze = {}};
  for (const std::string& id : method_ids()) {
    const auto plain = draw_cards(id, smoke, {});
    const auto no_haze_yet = draw_cards(id, smoke, {.distortion = true, .lens = {}});
    for (const char* pass : {"distortion", "surface", "outputs", "distort", "depth_of_field"})
      EXPECT_FALSE(names(plain.report).contains(pass)) << id << " " << pass;
    EXPECT_EQ(names(plain.report), names(no_haze_yet.report)) << id;
    EXPECT_EQ(plain.picture, no_haze_yet.picture) << id;
    EXPECT_TRUE(no_haze_yet.report.left_out.empty()) << id;
  }
}

TEST_F(OutputsTest, AMethodThatDoesNotWriteAnOutputIsNamed) {
  const Cards cards{.scalar = {card(4, 2, 0.5f)}, .haze = {haze(3, 2, 0.1f)}};
  for (const std::string& id : method_ids()) {
    const Outputs writes = make_method(id)->outputs();
    std::vector<std::string> expected;
    if (!writes.distortion) expected.push_back("distortion");
    if (!writes.surface) expected.push_back("surface");
    const auto drawn = draw_cards(id, cards, {.distortion = true, .lens = Lens{}});
    EXPECT_EQ(expected, drawn.report.left_out) << id;
    EXPECT_EQ(writes.distortion, names(drawn.report).contains("distort")) << id;
    EXPECT_TRUE(names(drawn.report).contains("depth_of_field")) << id;
  }
}

TEST_F(OutputsTest, AScenesHazeAndLensReachThePicture) {
  Scene scene = library.scene("haze");
  EXPECT_TRUE(Stage(device, pipelines, library, scene).post().distortion);
  EXPECT_FALSE(Stage(device, pipelines, library, scene).post().lens);
  const Scene focus = library.scene("focus");
  const Post post = Stage(device, pipelines, library, focus).post();
  ASSERT_TRUE(post.lens);
  EXPECT_FALSE(post.distortion);
  EXPECT_FLOAT_EQ(focus.depth_of_field->focus_m, post.lens->focus_m);
  for (Instance& i : scene.instances) i.call_tick.reset();
  EXPECT_FALSE(Stage(device, pipelines, library, scene).post().distortion) << "declared, not called";
}

}  // namespace
}  // namespace plume
