// The bounded A-buffer: which fragments stay, what becomes of the others, and what its formats round away.
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

using Map = std::map<std::string, std::string>;

/// Light and transmittance that the formats hold exactly, and the card that has them.
struct Exact {
  double z;
  glm::dvec3 light, through;
};

class AbufferTest : public AvboitTest {
 protected:
  AbufferTest() {
    size = {24, 16};
    scene.light.horizon = {0.25f, 0.5f, 0.75f};
  }
  Random random{1};

  struct Drawn {
    std::vector<glm::vec3> pixels;
    nlohmann::json statistics;
  };
  Drawn draw_abuffer(const Map& settings) {
    const std::unique_ptr<World> w = world();
    MethodInstance method = instance("abuffer", settings);
    render_frame(device, pipelines, w->targets, w->prelude(), w->transparents(), method);
    return {read_picture(device, w->targets).linear.pixels,
            method.method->statistics(device, method.resources)};
  }
  void add_exact(const Exact& e) {
    const double covers = 1.0 - std::min({e.through.r, e.through.g, e.through.b});
    add({.z = float(e.z),
         .optical_depth = -float(std::log1p(-covers)),
         .color = e.light / covers,
         .transmission = 1.0 - (1.0 - e.through) / covers});
  }
  /// Cards at depths of their own, in no order.
  std::vector<Exact> add_exact_stack(int count, bool rgb_transmission) {
    clear_cards();
    std::vector<Exact> all;
    for (int i = 0; i < count; ++i) {
      const auto light = [&] { return (32 + random.below(32)) / 64.0 / (1 << random.below(4)); };
      const auto through = [&] { return (33 + random.below(30)) / 64.0; };
      Exact e{.z = 3 + 0.25 * i, .light = {light(), light(), light()}, .through = glm::dvec3(0)};
      e.light.b = std::floor(e.light.b * 32 * 8) / (32 * 8);  // a bit less in blue
      if (rgb_transmission)
        e.through = {through(), through(), (17 + random.below(14)) / 32.0};
      else
        e.through = glm::dvec3((127 + random.below(120)) / 255.0);
      all.push_back(e);
    }
    random.shuffle(all);
    for (const Exact& e : all) add_exact(e);
    std::ranges::sort(all, {}, &Exact::z);
    return all;
  }
  /// The nearest, over the average of the others, over the horizon.
  glm::dvec3 composite(const std::vector<Exact>& sorted, size_t layers) const {
    glm::dvec3 light(0), through(1), tail_light(0), tail_weight(0), tail_through(1);
    for (size_t i = 0; i < sorted.size(); ++i)
      if (i < layers) {
        light += sorted[i].light * through;
        through *= sorted[i].through;
      } else {
        tail_light += sorted[i].light;
        tail_weight += 1.0 - sorted[i].through;
        tail_through *= sorted[i].through;
      }
    if (sorted.size() > layers) light += tail_light / tail_weight * (1.0 - tail_through) * through;
    return light + glm::dvec3(scene.light.horizon) * tail_through * through;
  }
  static Map rgb_is(bool each_channel) { return {{"rgb", each_channel ? "true" : "false"}}; }
};

TEST_F(AbufferTest, IsTheNearestFragmentsOverTheAverageOfTheOthers) {
  for (const bool each_channel : {true, false})
    for (const char* layers : {"1", "4", "9"})
      for (const char* depth_bits : {"16", "24"}) {
        const auto stack = add_exact_stack(12, each_channel);
        Map settings = rgb_is(each_channel);
        settings["layers"] = layers, settings["depth_bits"] = depth_bits;
        const Drawn drawn = draw_abuffer(settings);
        const size_t kept = size_t(std::stoi(layers)), pixels = drawn.pixels.size();
        const glm::dvec3 expected = composite(stack, kept);
        for (const glm::vec3& pixel : drawn.pixels)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(expected[c], double(pixel[c]), 3e-3)
                << layers << " layers, rgb " << each_channel << ", channel " << c;
        EXPECT_EQ((12 - kept) * pixels, drawn.statistics["fragments_in_tail"]);
        EXPECT_EQ(pixels, drawn.statistics["pixels_with_tail"]);
      }
}

TEST_F(AbufferTest, KeepingTheNearestTheOrderOfDrawsChangesNoBitOfTheLayers) {
  for (const bool each_channel : {true, false}) {
    // Three at each depth: ties, as many as there are layers.
    clear_cards();
    for (int i = 0; i < 9; ++i)
      add({.z = 4 + float(i / 3),
           .optical_depth = random.f(0.1, 2),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .yaw = i % 3 == 0 ? 0.2f : 0.0f});
    order.resize(9);
    std::iota(order.begin(), order.end(), 0u);
    const Drawn in_order = draw_abuffer(rgb_is(each_channel));
    EXPECT_EQ(0, in_order.statistics["fragments_in_tail"]);
    for (int round = 0; round < 3; ++round) {
      random.shuffle(order);
      EXPECT_EQ(in_order.pixels, draw_abuffer(rgb_is(each_channel)).pixels);
    }
  }
}

TEST_F(AbufferTest, KeepingTheFirstIsTheSameWhereNothingOverflows) {
  for (const bool each_channel : {true, false}) {
    const auto stack = add_exact_stack(9, each_channel);
    Map settings = rgb_is(each_channel);
    const auto nearest = draw_abuffer(settings).pixels;
    settings["keep"] = "first";
    const Drawn first = draw_abuffer(settings);
    EXPECT_EQ(nearest, first.pixels);
    EXPECT_EQ(0, first.statistics["fragments_in_tail"]);
  }
}

TEST_F(AbufferTest, KeepingTheFirstTheOrderOfDrawsShowsWhereLayersOverflow) {
  // Ten cards of which a near red one comes first or last; the device draws one card after the other.
  const auto shot = [&](const char* keep, bool red_last) {
    clear_cards();
    if (!red_last) add({.z = 3, .optical_depth = 2, .color = {0.9f, 0, 0}});
    for (int i = 0; i < 9; ++i) add({.z = 5 + float(i), .optical_depth = 2, .color = {0, 0.9f, 0}});
    if (red_last) add({.z = 3, .optical_depth = 2, .color = {0.9f, 0, 0}});
    const Drawn drawn = draw_abuffer({{"keep", keep}});
    EXPECT_EQ(drawn.pixels.size(), drawn.statistics["fragments_in_tail"]) << keep;
    return drawn.pixels[0];
  };
  EXPECT_EQ(shot("nearest", false), shot("nearest", true));
  EXPECT_GT(shot("first", false).r, 0.7f);
  EXPECT_LT(shot("first", true).r, 0.001f);
}

TEST_F(AbufferTest, MoreFragmentsThanLayersTurnIntoAnAverage) {
  // What the talk calls overflow: behind nine wisps of smoke, a green card hides a red one no more.
  for (int i = 0; i < 9; ++i) add({.z = 2 + float(i) * 0.1f, .optical_depth = 0.02f});
  add({.z = 5, .optical_depth = 5, .color = {0, 0.8f, 0}});
  add({.z = 6, .optical_depth = 5, .color = {0.8f, 0, 0}});
  const glm::vec3 exact = draw_cards("reference").linear.pixels[0], drawn = draw_abuffer({}).pixels[0],
                  enough = draw_abuffer({{"layers", "11"}}).pixels[0];
  EXPECT_LT(exact.r, 0.01f);
  EXPECT_GT(drawn.r, 0.3f);
  EXPECT_NEAR(exact.r, enough.r, 0.01f);
  EXPECT_NEAR(exact.g, enough.g, 0.02f);
}

TEST_F(AbufferTest, UncoveredEmissionIsAddedWhereLayersOverflow) {
  add({.z = 3, .optical_depth = 0.7f, .color = glm::vec3(0.1f)});
  for (int i = 0; i < 5; ++i)
    add({.z = 5 + float(i), .optical_depth = i == 2 ? 0.1f : 0.0f, .emission = {0.5f, 0.25f, 0.125f}});
  const glm::vec3 exact = draw_cards("reference").linear.pixels[0];
  for (const char* keep : {"nearest", "first"})
    for (const bool each_channel : {true, false}) {
      Map settings = rgb_is(each_channel);
      settings["keep"] = keep, settings["layers"] = "1";
      const Drawn drawn = draw_abuffer(settings);
      EXPECT_EQ(5 * drawn.pixels.size(), drawn.statistics["fragments_in_tail"]);
      // The one that covers dims three of the others by a tenth where all are sorted.
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(exact[c], drawn.pixels[0][c], 0.15f * exact[c]) << keep;
    }
}

TEST_F(AbufferTest, WithoutAtomicsOf64BitsTheFirstCanBeKept) {
  const gpu::Device lacking({.fault = "missing@shaderBufferInt64Atomics"});
  const auto method = make_method("abuffer");
  EXPECT_TRUE(method->missing(device).empty());
  ASSERT_EQ(1u, method->missing(lacking).size());
  EXPECT_EQ("shaderInt64 and shaderBufferInt64Atomics, or keep=first", method->missing(lacking)[0]);
  set_parameter(*method, "keep", "first");
  EXPECT_TRUE(method->missing(lacking).empty());
}

TEST_F(AbufferTest, EightBitsOfTransmittanceLoseThinSmoke) {
  // Each blocks 1/600 of white: 255 of 255 pass.
  scene.light.horizon = glm::vec3(1.0f);
  for (int i = 0; i < 32; ++i) add({.z = 3 + float(i) * 0.25f, .optical_depth = 1.0f / 600});
  EXPECT_NEAR(std::exp(-32.0 / 600), double(draw_cards("reference").linear.pixels[0].g), 1e-3);
  EXPECT_EQ(1.0f, draw_abuffer({{"layers", "32"}, {"rgb", "false"}}).pixels[0].g);
}

TEST_F(AbufferTest, SixteenBitsOfDepthSwapPanesThatTwentyFourTellApart) {
  // The talk's hard case: panes 1/8 inch apart, clear in front, almost opaque red behind.
  add({.z = 6.9985f, .optical_depth = 0.5f, .color = {0, 0, 1}});
  add({.z = 6.9985f + 0.0032f, .optical_depth = 5, .color = {1, 0, 0}});
  const glm::vec3 exact = draw_cards("reference").linear.pixels[0];
  const auto blue = [&](const char* depth_bits) {
    return draw_abuffer({{"rgb", "false"}, {"depth_bits", depth_bits}}).pixels[0].b;
  };
  EXPECT_NEAR(exact.b, blue("24"), 0.01f);
  EXPECT_LT(blue("16"), 0.1f * exact.b);
}

TEST_F(AbufferTest, LightIsRoundedToTheNearestItsFormatHolds) {
  scene.light.horizon = glm::vec3(0.0f);
  for (const bool each_channel : {true, false})
    for (int round = 0; round < 12; ++round) {
      clear_cards();
      const glm::vec3 light(random.octaves(1e-3, 6e4), random.octaves(1e-3, 6e4), random.octaves(1e-3, 6e4));
      add({.z = 5, .optical_depth = 0, .emission = light});
      const glm::vec3 drawn = draw_abuffer(rgb_is(each_channel)).pixels[0];
      // Half a step of 6, 6 and 5 bits below the leading one, and the card's own half floats.
      const glm::vec3 half_step{1.0f / 128, 1.0f / 128, 1.0f / 64};
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(light[c], drawn[c], light[c] * (half_step[c] + 1e-3f)) << "channel " << c;
    }
}

}  // namespace
}  // namespace plume
