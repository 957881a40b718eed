// Weighted blending beside what the draws of quads_test.cpp show of its weights: its equation for any stack,
// what its targets can hold, its two resolutions, its outputs, and its known failures.
#include "tests/gpu/weighted_scene.h"

namespace plume {
namespace {

using Settings = std::map<std::string, std::string>;

class WboitTest : public WeightedTest {
 protected:
  /// Of the layers' shares, and of what they cover in all.
  struct Model {
    double sum = 0, covers = 0;
    glm::dvec3 image{0.0};
  };
  Model model(const std::string& name, const std::vector<WeightedLayer>& layers) const {
    Model m;
    glm::dvec3 light(0.0);
    double reveal = 1;
    for (const WeightedLayer& layer : layers) {
      const double a = layer.reduced();
      // The colour rides along with the whole coverage: premultiplied, it is light that leaves the layer.
      const glm::dvec3 leaves = halved(layer.color) * layer.coverage;
      const double w =
          wboit_weight(name, a > 0 ? leaves / a : glm::dvec3(0), a, layer.z, scene.near_m, scene.far_m);
      light += leaves * w;
      m.sum += a * w;
      reveal *= 1 - a;
    }
    m.covers = 1 - reveal;
    m.image = light / std::max(m.sum, 1e-5) * m.covers + glm::dvec3(scene.light.horizon) * reveal;
    return m;
  }
};

TEST_F(WboitTest, AnyStackIsTheEquationAtEveryPrecision) {
  Random random(11);
  scene.light.horizon = {0.2f, 0.5f, 0.9f};
  for (int round = 0; round < 24; ++round) {
    const std::vector<WeightedLayer> layers = random_stack(random);
    stack(layers);
    const std::string weight = kWboitWeights[round % 6];
    const bool full = round % 2 == round / 6 % 2;
    const Settings settings{
        {"weight", weight}, {"sums", full ? "float" : "half"}, {"revealage", full ? "float" : "half"}};
    const Drawn drawn = draw("wboit", settings);
    if (drawn.statistics["overflowed_pixels"] != 0u) continue;
    expect_near(model(weight, layers).image, middle(drawn), full ? 1.5e-3 : 8e-3,
                weight + " round " + std::to_string(round));
  }
}

// 65504 / 3000 = 21.8.
TEST_F(WboitTest, SixteenBitSumsOverflowAtTwentyTwoFragmentsOfWeight3000AndAreCounted) {
  const auto shot = [&](int fragments, const char* sums) {
    stack(std::vector<WeightedLayer>(size_t(fragments),
                                     {.color = {0.5, 0.25, 0.125}, .coverage = 1, .z = 0.5}));
    return draw("wboit", {{"weight", "eq9"}, {"sums", sums}});
  };
  const Drawn fits = shot(21, "half"), too_many = shot(22, "half"), wide = shot(22, "float");
  EXPECT_EQ(0u, fits.statistics["overflowed_pixels"]);
  EXPECT_EQ(size.x * size.y, too_many.statistics["overflowed_pixels"]);
  EXPECT_EQ(0u, wide.statistics["overflowed_pixels"]);
  expect_near({0.5, 0.25, 0.125}, middle(fits), 1e-3, "21");
  expect_near({1, 1, 1}, middle(too_many), 1e-3, "22: the published patch shows the coverage");
  expect_near({0.5, 0.25, 0.125}, middle(wide), 1e-3, "32 bits");
}

TEST_F(WboitTest, EightBitsOfRevealageStopHalfAStepBeforeAThinFragmentAndNeverHide) {
  scene.light.horizon = {1, 1, 1};
  const double alpha = 0.05;
  stack(std::vector<WeightedLayer>(160, {.coverage = alpha}));
  double steps = 255;
  for (int i = 0; i < 160; ++i) steps = std::round(steps * (1 - alpha));
  ASSERT_NEAR(0.5 / alpha, steps, 1.0);
  // Devices may round a product of two 8-bit numbers either way.
  expect_near(glm::dvec3(steps / 255), middle(draw("wboit", {{"revealage", "unorm8"}})), 1.2 / 255, "8 bits");
  expect_near(glm::dvec3(std::pow(1 - alpha, 160)), middle(draw("wboit", {{"revealage", "half"}})), 1e-4,
              "16 bits");
}

// Sums add and revealages multiply: particles in front of, between and behind surfaces give what one
// resolution gives, and the surfaces keep their edges.
TEST_F(WboitTest, LowResolutionParticlesInterleaveInDepthWithSharpSurfaces) {
  size = {61, 35};
  scene.light.horizon = {0.9f, 0.8f, 0.7f};
  const auto interleave = [&] {
    clear_cards();
    for (int i = 0; i < 6; ++i) {
      const bool sharp = i % 2 != 0;
      PlacedCard card = card_of({.color = glm::dvec3(i == 1, i == 3, i == 5) + 0.2,
                                 .coverage = sharp ? 0.7 : 0.3,
                                 .transmission = sharp ? glm::dvec3(0.6, 0.1, 0.3) : glm::dvec3(0),
                                 .z = 2.0 + i},
                                sharp ? shared::kSolidLayer : 0);
      if (sharp)
        card.half_size = glm::vec2(0.13f, 0.2f) * float(card.z),
        card.at = glm::vec2(0.05f, 0.02f) * float(card.z) * float(i - 3);
      add(card);
    }
  };
  interleave();
  const Drawn full = draw("wboit");
  for (const char* resolution : {"half", "quarter"}) {
    const Drawn low = draw("wboit", {{"particles", resolution}});
    for (size_t i = 0; i < full.pixels.size(); ++i)
      expect_near(full.pixels[i], low.pixels[i], 3e-3,
                  std::string(resolution) + " pixel " + std::to_string(i));
  }
}

TEST_F(WboitTest, ParticlesAreBlurredOnlyAtTheirOwnEdges) {
  size = {64, 36};
  PlacedCard puff = card_of({.color = {1, 1, 1}, .coverage = 1, .z = 4});
  puff.half_size = {1.13f, 100};
  add(puff);
  const Drawn full = draw("wboit");
  for (const auto& [resolution, reach] : {std::pair("half", 2), std::pair("quarter", 4)}) {
    const Drawn low = draw("wboit", {{"particles", resolution}});
    int changed = 0, farthest = 0;
    for (uint32_t x = 1; x + 1 < size.x; ++x) {
      if (std::abs(full.pixels[x].r - low.pixels[x].r) < 2e-3f) continue;
      ++changed;
      int nearest_edge = 99;
      for (uint32_t e = 0; e + 1 < size.x; ++e)
        if (full.pixels[e].r != full.pixels[e + 1].r)
          nearest_edge =
              std::min(nearest_edge, std::min(std::abs(int(x) - int(e)), std::abs(int(x) - int(e) - 1)));
      farthest = std::max(farthest, nearest_edge);
    }
    EXPECT_GT(changed, 1) << resolution;
    EXPECT_LE(farthest, reach) << resolution;
  }
}

// Low-resolution texels are tested against the farthest depth they hold: on an edge of an opaque thing,
// pixels that have no texel of their own depth take their neighbours'.
TEST_F(WboitTest, LowResolutionParticlesReachOverAnOpaqueEdgeByHalfATexelAtMost) {
  size = {64, 36};
  Solid post, wall;
  post.material = wall.material = Material::kUnlit;
  post.color = {0.1f, 0.6f, 0.2f};
  post.position = {0.03f, 0, -2};
  post.size_m = {1.1f, 9, 0.1f};
  wall.color = {0.8f, 0.1f, 0.1f};
  wall.position = {0, 0, -20};
  wall.size_m = {200, 200, 1};
  scene.solids = {post, wall};
  stack({{.color = {0.9, 0.9, 1}, .coverage = 0.8, .z = 5}});
  const Drawn full = draw("wboit");
  for (const auto& [resolution, texel] : {std::pair("half", 2), std::pair("quarter", 4)}) {
    const Drawn low = draw("wboit", {{"particles", resolution}});
    for (int x = 0; x < int(size.x); ++x) {
      bool at_edge = false;
      for (int e = std::max(x - texel / 2, 0); e < std::min(x + texel / 2, int(size.x) - 1); ++e)
        at_edge = at_edge || glm::length(full.pixels[size_t(e)] - full.pixels[size_t(e) + 1]) > 0.1f;
      if (at_edge) continue;
      EXPECT_LT(glm::length(full.pixels[size_t(x)] - low.pixels[size_t(x)]), 0.05f) << resolution << " " << x;
    }
  }
}

// The depth that depth of field sees is weighted as the image is: each layer by its share of the fraction.
TEST_F(WboitTest, TheDepthOfTheCompositeIsTheMeanOfItsLayersByTheirShares) {
  const std::vector<WeightedLayer> layers{
      {.coverage = 0.6, .z = 3}, {.coverage = 0.5, .z = 7}, {.coverage = 0.9, .z = 20}};
  stack(layers);
  for (const std::string particles : {"full", "half"}) {
    const glm::dvec4 got =
        draw("wboit", {{"weight", "eq8"}, {"particles", particles}}, {.surface = true, .lens = {}})
            .surface[0];
    const Model m = model("eq8", layers);
    double inverse = 0, seen = 0;
    for (const WeightedLayer& layer : layers) {
      const double share =
          wboit_weight("eq8", layer.color, layer.coverage, layer.z, scene.near_m, scene.far_m) * m.covers /
          m.sum;
      inverse += layer.coverage * std::min(share, 1.0) / layer.z;
      seen += layer.coverage * std::min(share, 1.0);
    }
    EXPECT_NEAR(seen, got.y, 3e-3) << particles;
    EXPECT_NEAR(inverse, got.x, 1e-3) << particles;
  }
}

TEST_F(WboitTest, TheProbeTellsTheShareOfAnOpaqueFragmentAtEveryResolution) {
  const std::vector<WeightedLayer> layers{{.coverage = 0.6, .z = 3}, {.coverage = 0.5, .z = 7}};
  stack(layers);
  const Model m = model("eq7", layers);
  for (const double z : {2.0, 5.0, 9.0}) {
    const double share = wboit_weight("eq7", {}, 1, z, scene.near_m, scene.far_m) * m.covers / m.sum;
    for (const char* particles : {"full", "half"})
      expect_near(glm::dvec3(share), probe_at("wboit", z, {{"particles", particles}}), 4e-3 * share,
                  particles);
  }
}

TEST_F(WboitTest, AnOpaqueLayerDoesNotHideTheNextOne) {
  stack({{.color = {1, 0, 0}, .coverage = 1, .z = 2}, {.color = {0, 1, 0}, .coverage = 1, .z = 4}});
  expect_near({1, 0, 0}, middle(draw("reference")), 1e-3, "reference");
  const double near = wboit_weight("eq7", {}, 1, 2, scene.near_m, scene.far_m),
               far = wboit_weight("eq7", {}, 1, 4, scene.near_m, scene.far_m);
  const glm::vec3 seen = middle(draw("wboit"));
  expect_near({near / (near + far), far / (near + far), 0}, seen, 2e-3, "wboit");
  EXPECT_GT(seen.g, 0.15f);
}

// The positive control of a smoke grenade: people behind its bank are hidden exactly. WBOIT shows one of
// opaque cards, since its weight does not know what stands in front; and where a solid one stands, since the
// smoke that it hides is missing from the average.
TEST_F(WboitTest, PeopleBehindASmokeGrenadeShowThatTheReferenceHides) {
  const glm::uvec2 picture{128, 72};
  const std::vector<std::pair<std::string, Settings>> methods{
      {"reference", {}}, {"wboit", {}}, {"wboit", {{"sums", "float"}, {"revealage", "float"}}}};
  const auto shots = [&](const Scene& smoky) {
    Stage stage(device, pipelines, library, smoky);
    const Targets targets(device, picture);
    stage.go_to(smoky.default_tick, picture);
    std::vector<std::vector<glm::vec3>> drawn;
    for (const auto& [id, settings] : methods) {
      MethodInstance method = instance(id, settings);
      drawn.push_back(GpuTest::draw(stage, targets, method).linear.pixels);
    }
    return drawn;
  };
  /// On the 60 pixels that change most: about half of a person.
  const auto difference = [](const std::vector<glm::vec3>& a, const std::vector<glm::vec3>& b) {
    std::vector<double> each;
    for (size_t i = 0; i < a.size(); ++i) each.push_back(double(glm::length(a[i] - b[i])));
    std::ranges::sort(each, std::greater());
    return std::accumulate(each.begin(), each.begin() + 60, 0.0) / 60;
  };
  const Scene both = library.scene("behind_smoke");
  Scene no_cards = both, no_solid = both;
  no_cards.panes.clear();
  std::erase_if(no_solid.solids, [](const Solid& s) { return s.material == Material::kUnlit; });
  const auto with = shots(both), without_cards = shots(no_cards), without_solid = shots(no_solid);
  EXPECT_LT(difference(with[0], without_cards[0]), 0.002);
  EXPECT_GT(difference(with[1], without_cards[1]), 0.04);
  EXPECT_GT(difference(with[2], without_cards[2]), 0.04) << "precision is no help";
  EXPECT_LT(difference(with[0], without_solid[0]), 0.002);
  EXPECT_GT(difference(with[1], without_solid[1]), 0.004);
}

}  // namespace
}  // namespace plume
