// What must hold of the picture whatever the parameters are.
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

using Map = std::map<std::string, std::string>;

class AvboitParameters : public AvboitTest {
 protected:
  AvboitParameters() {
    size = {34, 18};
    scene.light.horizon = {0.2f, 0.3f, 0.5f};
  }
  Random random{1};

  static std::vector<Map> variants() {
    std::vector<Map> all{{}};
    const auto each = [&](const char* name, std::initializer_list<const char*> values) {
      for (const char* value : values) all.push_back({{name, value}});
    };
    each("resolution", {"1/2", "1/4"});
    each("slices", {"32", "256"});
    each("splat", {"packed8", "packed8_exchange", "packed8_overflow", "words32"});
    each("rgb_splat", {"packed10"});
    each("linear_splat", {"false"});
    each("dither", {"true"});
    each("samples", {"4"});
    each("sampling", {"point", "linear", "quadratic", "cubic"});
    each("colour", {"mono", "total_extinction", "skew", "first_event"});
    each("exact_layers", {"0", "2", "8"});
    each("accumulation", {"16f", "deterministic"});
    each("zero_depth", {"off", "fullscreen"});
    each("sparse", {"false"});
    each("normalise", {"false"});
    all.push_back({{"sampling", "linear"}, {"eight_bits", "true"}});
    return all;
  }
  static std::string text(const Map& settings) {
    std::string all = "default";
    for (const auto& [name, value] : settings) all = name + "=" + value;
    return all;
  }
};

TEST_F(AvboitParameters, OneSmoothCardIsPlainBlending) {
  for (const Map& settings : variants())
    for (const float coverage : {0.02f, 0.6f, 0.999f}) {
      SCOPED_TRACE(text(settings) + " coverage " + std::to_string(coverage));
      clear_cards();
      const glm::vec3 color{0.8, 0.4, 0.1};
      add({.z = 5.3f, .optical_depth = -std::log1p(-coverage), .color = color});
      const glm::vec3 expected = color * coverage + scene.light.horizon * (1 - coverage);
      // Three roundings of half floats where the sum is scaled to the coverage; unscaled, a fragment that
      // takes itself out of an integral of half floats errs by one of their steps at an optical depth of 7,
      // 1/256.
      const float bound = settings.contains("normalise") ? 1.0f / 256 : 3.0f / 2048;
      for (const glm::vec3& pixel : draw_cards("avboit", settings).linear.pixels)
        for (int c = 0; c < 3; ++c) ASSERT_NEAR(expected[c], pixel[c], bound);
    }
}

TEST_F(AvboitParameters, AnUncoveredEmissionIsAdded) {
  for (const Map& settings : variants()) {
    SCOPED_TRACE(text(settings));
    clear_cards();
    add({.z = 5.3f, .optical_depth = 0, .emission = {0.3f, 0.2f, 0.1f}});
    const shared::Card card = scalar[0];
    const glm::vec2 rg = glm::unpackHalf2x16(card.emission.x), b = glm::unpackHalf2x16(card.emission.y);
    for (const glm::vec3& pixel : draw_cards("avboit", settings).linear.pixels)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(scene.light.horizon[c] + glm::vec3(rg.x, rg.y, b.x)[c], pixel[c], 3.0f / 2048);
  }
}

TEST_F(AvboitParameters, CoverageAddsUpWhateverTheOrderOfDraws) {
  for (const Map& settings : variants()) {
    SCOPED_TRACE(text(settings));
    clear_cards();
    for (int i = 0; i < 60; ++i)
      add({.z = float(random.octaves(3, 12)),
           .optical_depth = float(random.octaves(0.05, 1)),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .transmission = i % 6 == 0 ? glm::vec3(0.9f, 0.2f, 0.4f) : glm::vec3(0.0f),
           .half_size = {2, 2},
           .at = {random.f(-3, 3), random.f(-2, 2)},
           .yaw = i % 2 ? 0.0f : random.f(-1, 1),
           .layer = i % 7 == 0 ? shared::kSolidLayer : 0});
    const auto in_order = draw_cards("avboit", settings).display.pixels;
    order.resize(scalar.size() + rgb.size());
    std::iota(order.begin(), order.end(), 0u);
    random.shuffle(order);
    const auto shuffled = draw_cards("avboit", settings).display.pixels;
    // Packed words are the same to the bit; half floats round otherwise in another order.
    for (size_t i = 0; i < in_order.size(); ++i)
      for (size_t c = 0; c < 3; ++c) ASSERT_NEAR(in_order[i][c], shuffled[i][c], 1) << "pixel " << i;
  }
}

TEST_F(AvboitParameters, NothingTransparentLeavesTheBackground) {
  for (const Map& settings : variants()) {
    SCOPED_TRACE(text(settings));
    for (const glm::vec3& pixel : draw_cards("avboit", settings).linear.pixels)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(scene.light.horizon[c], pixel[c], 1.0f / 2048);
  }
}

}  // namespace
}  // namespace plume
