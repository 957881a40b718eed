// What must hold for every method alike. A new method is tested by being in the list.
#include <algorithm>
#include <numeric>
#include <random>

#include "sandbox/measure/metrics.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{66, 34};  // no multiple of a cell of 8

class MethodProperties : public GpuTest, public testing::WithParamInterface<std::string> {
 protected:
  /// A grey room without sky or tone map, so that values are what they are.
  static Scene room() {
    Scene scene;
    scene.id = "room";
    scene.light.sky = false;
    scene.light.horizon = {0.2f, 0.3f, 0.5f};
    scene.tonemap = Tonemap::kNone;
    scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
    return scene;
  }
  static Pane card(float z, float coverage, glm::vec3 color) {
    return {.position = {0, 0, z}, .size_m = {40, 40}, .color = color, .coverage = coverage};
  }
  DrawnPicture draw_scene(Scene scene, glm::uvec2 size = kSize) {
    Stage stage(device, pipelines, library, std::move(scene));
    return draw(stage, 0, size, GetParam());
  }
  static void expect_everywhere(const DrawnPicture& picture, glm::vec3 expected, float tolerance) {
    for (size_t i = 0; i < picture.linear.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(expected[c], picture.linear.pixels[i][c], tolerance) << "pixel " << i << " channel " << c;
  }
};

INSTANTIATE_TEST_SUITE_P(All, MethodProperties, testing::ValuesIn(method_ids()),
                         [](const auto& method) { return method.param; });

// Half floats carry 11 bits: one rounding of a value below 1 is at most 2^-12.
constexpr float kHalfRounding = 1.0f / 2048;

TEST_P(MethodProperties, AnEmptySceneIsTheBackground) {
  expect_everywhere(draw_scene(room()), {0.2, 0.3, 0.5}, kHalfRounding);
}

TEST_P(MethodProperties, OneFragmentIsPlainBlending) {
  for (const float alpha : {0.004f, 0.1f, 0.5f, 0.9f, 1.0f}) {
    Scene scene = room();
    const glm::vec3 color{0.8, 0.4, 0.1};
    scene.panes = {card(0, alpha, color)};
    // Weighted methods divide two half-float sums: three roundings.
    expect_everywhere(draw_scene(scene), color * alpha + scene.light.horizon * (1 - alpha),
                      3 * kHalfRounding + float(make_method(GetParam())->traits().rounding));
  }
}

TEST_P(MethodProperties, AnUncoveredEmissionIsAdded) {
  Scene scene = room();
  scene.panes = {card(0, 0, glm::vec3(0))};
  scene.panes[0].emission = {0.3, 0.2, 0.1};
  expect_everywhere(draw_scene(scene), scene.light.horizon + scene.panes[0].emission, 3 * kHalfRounding);
}

TEST_P(MethodProperties, AnUncoveredEmissionNeverTurnsIntoNanOrInfinity) {
  Scene scene = room();
  for (int i = 0; i < 40; ++i) {
    scene.panes.push_back(card(float(i) * 0.05f, i % 2 ? 0.3f : 0.0f, glm::vec3(0.5)));
    if (i % 2 == 0) scene.panes.back().emission = glm::vec3(50.0);
  }
  const DrawnPicture picture = draw_scene(scene);
  for (const glm::vec3& pixel : picture.linear.pixels)
    for (int c = 0; c < 3; ++c) {
      ASSERT_TRUE(std::isfinite(pixel[c]));
      ASSERT_GE(pixel[c], 0.0f);
    }
}

TEST_P(MethodProperties, CardsThatShowNothingLeaveNoTrace) {
  if (GetParam() == "stochastic") GTEST_SKIP() << "which samples a card covers depends on its number";
  Scene scene = room(), with_hidden = room();
  for (int i = 0; i < 12; ++i) {
    const Pane seen = card(0.3f * float(i) - 2, 0.1f + 0.05f * float(i), {0.1f * float(i), 0.5f, 0.2f});
    scene.panes.push_back(seen);
    for (int hidden = 0; hidden < 30; ++hidden)
      with_hidden.panes.push_back(card(float(hidden % 7) - 3, 0, {1, 1, 1}));
    with_hidden.panes.push_back(seen);
  }
  const auto without = draw_scene(scene).linear.pixels, with = draw_scene(with_hidden).linear.pixels;
  for (size_t i = 0; i < without.size(); ++i) ASSERT_EQ(without[i], with[i]) << "pixel " << i;
}

TEST_P(MethodProperties, OpaqueThingsHideWhatIsBehindThem) {
  Scene scene = room();
  Solid wall;
  wall.material = Material::kUnlit;
  wall.color = {0.1, 0.2, 0.3};
  wall.position = {0, 0, 1};
  wall.size_m = {60, 60, 0.5};
  scene.solids = {wall};
  scene.panes = {card(0, 0.7f, {1, 1, 1}), card(-20, 0.7f, {1, 0, 1})};
  expect_everywhere(draw_scene(scene), {0.1, 0.2, 0.3}, kHalfRounding);
}

TEST_P(MethodProperties, TheOrderOfDrawsChangesNothingBeyondRounding) {
  Stage stage(device, pipelines, library, library.scene("street"));
  const Targets targets(device, {160, 90});
  stage.go_to(260, targets.size);
  MethodInstance method = instance(GetParam());
  const DrawnPicture in_order = draw(stage, targets, method);

  std::vector<uint32_t> order(stage.transparents().count);
  std::iota(order.begin(), order.end(), 0u);
  std::mt19937 random(3);
  for (int round = 0; round < 4; ++round) {
    if (round == 0)
      std::ranges::reverse(order);
    else
      std::ranges::shuffle(order, random);
    stage.set_draw_order(order);
    const DrawnPicture shuffled = draw(stage, targets, method);
    for (size_t i = 0; i < in_order.display.pixels.size(); ++i)
      for (size_t c = 0; c < 3; ++c)  // half-float sums round differently in another order: 2/255 is allowed
        ASSERT_NEAR(int(in_order.display.pixels[i][c]), int(shuffled.display.pixels[i][c]), 2)
            << "pixel " << i;
  }
}

TEST_P(MethodProperties, ResizingAndSwitchingLeaveNoTrace) {
  Stage stage(device, pipelines, library, library.scene("street"));
  MethodInstance method = instance(GetParam());
  const auto shot = [&](uint32_t tick, glm::uvec2 size, MethodInstance& with) {
    const Targets targets(device, size);
    stage.go_to(tick, size);
    return draw(stage, targets, with).linear.pixels;
  };
  const auto before = shot(200, kSize, method);
  shot(400, {17, 9}, method);
  for (const std::string& id : method_ids()) {
    MethodInstance other = instance(id);
    shot(200, {40, 50}, other);
  }
  shot(30, {200, 120}, method);
  const auto after = shot(200, kSize, method);
  ASSERT_EQ(before.size(), after.size());
  for (size_t i = 0; i < before.size(); ++i) ASSERT_EQ(before[i], after[i]) << "pixel " << i;
}

TEST_P(MethodProperties, ATinyPictureIsDrawn) {
  Scene scene = room();
  scene.panes = {card(0, 0.5f, {1, 1, 1})};
  expect_everywhere(draw_scene(scene, {1, 1}), glm::vec3(0.5) + scene.light.horizon * 0.5f,
                    3 * kHalfRounding);
}

float brightest(const Image& image) {
  float most = 0.0f;
  for (const glm::vec3& pixel : image.pixels) most = std::max({most, pixel.r, pixel.g, pixel.b});
  return most;
}

TEST_P(MethodProperties, TheErrorOnTheStreetStaysBelowTheStatedBound) {
  Stage stage(device, pipelines, library, library.scene("street"));
  const uint32_t tick = stage.scene().default_tick;
  const Image exact = draw(stage, tick, {320, 180}, "reference").linear;
  const Image drawn = draw(stage, tick, {320, 180}, GetParam()).linear;
  const Traits traits = make_method(GetParam())->traits();
  if (traits.exact)
    EXPECT_LT(max_abs(exact, drawn).value, (1e-3 + traits.rounding) * brightest(exact));
  else
    EXPECT_LT(rmse(exact, drawn), traits.street_rmse);
}

// The middle of a slab of smoke is where a graph of transmittance matters. What a method tells there must be
// what it does to light that starts there.
TEST_P(MethodProperties, TheProbeTellsWhatLightReceives) {
  const Traits traits = make_method(GetParam())->traits();
  if (traits.emission.find("unattenuated") != std::string_view::npos)
    GTEST_SKIP() << "emission without coverage is not attenuated: there is nothing to compare with";
  Scene scene = room();
  for (int i = 0; i < 6; ++i) scene.panes.push_back(card(-float(i), 0.1f + 0.05f * float(i), glm::vec3(0.5)));
  scene.panes[3].transmission = {0.7, 0.5, 0.1};
  const std::vector<float> depths{4.0f, 5.5f, 6.5f, 7.5f, 8.5f, 9.5f, 12.0f};
  const glm::uvec2 pixel{33, 17};

  const auto probe_of = [&](const Scene& probed, const Probe* probe) {
    Stage stage(device, pipelines, library, probed);
    const Targets targets(device, kSize);
    stage.go_to(0, kSize);
    MethodInstance method = instance(GetParam());
    render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method, probe);
    return read_picture(device, targets).linear.pixels[pixel.y * kSize.x + pixel.x];
  };
  for (const float depth : depths) {
    Scene lit = scene;
    lit.panes.push_back(card(5.0f - depth, 0.0f, glm::vec3(0)));
    const glm::vec3 dark = probe_of(lit, nullptr);
    lit.panes.back().emission = glm::vec3(2.0f);
    const Probe probe(device, pixel, {depth});
    const glm::vec3 received = (probe_of(lit, &probe) - dark) / 2.0f;
    const glm::vec3 told = probe.read_answer(device)[0];
    // A method with one transmittance for all channels uses it for what shines too: the mean tells as much.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(told[c], received[c], 0.004) << "depth " << depth;
  }
}

}  // namespace
}  // namespace plume
