// Depth peeling against the exact reference, and against the same cards composited on the CPU in double.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "sandbox/measure/metrics.h"
#include "shaders/methods/parts/fragment_list/fragment_list.h"
#include "shaders/shared/draw_command.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

class PeelTest : public AvboitTest {
 protected:
  using Map = std::map<std::string, std::string>;
  struct Drawn {
    Image linear;
    nlohmann::json statistics;
    uint32_t redraws;
  };

  Drawn draw_peels(const World& w, MethodInstance& method, gpu::Pipelines& with) {
    const FrameReport report = render_frame(device, with, w.targets, w.prelude(), w.transparents(), method);
    return {read_picture(device, w.targets).linear, method.method->statistics(device, method.resources),
            report.redraws};
  }
  Drawn draw_peels(std::string_view id, const Map& settings = {}) {
    MethodInstance method = instance(id, settings);
    return draw_peels(*world(), method, pipelines);
  }

  /// Cards that fill the picture, at places that the test chooses.
  void add_filling(float z, float optical_depth, glm::vec3 color, glm::vec3 transmission = glm::vec3(0.0f)) {
    add({.z = z, .optical_depth = optical_depth, .color = color, .transmission = transmission});
  }

  /// Front to back by (depth, card), in double, over black; of the cards of `kept` only.
  template <class Kept>
  glm::dvec3 composite(const Kept& kept) const {
    const std::vector<shared::Card> all = cards();
    std::vector<size_t> by_depth(all.size());
    std::iota(by_depth.begin(), by_depth.end(), size_t(0));
    std::ranges::stable_sort(by_depth, [&](size_t a, size_t b) { return all[a].center.z > all[b].center.z; });
    glm::dvec3 light(0.0), through(1.0);
    for (size_t place = 0; place < by_depth.size(); ++place) {
      if (!kept(place)) continue;
      const shared::Card& card = all[by_depth[place]];
      const auto unpack = [](glm::uvec2 words) {
        return glm::dvec3(glm::unpackHalf2x16(words.x).x, glm::unpackHalf2x16(words.x).y,
                          glm::unpackHalf2x16(words.y).x);
      };
      const double coverage = 1 - std::exp(-double(card.optical_depth));
      light += through * coverage * unpack(card.ambient);
      through *= 1.0 - coverage * (1.0 - unpack(card.transmission));
    }
    return light;
  }
  static void expect_everywhere(const Image& image, glm::dvec3 expected, double tolerance) {
    for (size_t i = 0; i < image.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(expected[c], image.pixels[i][c], tolerance) << "pixel " << i;
  }
};

constexpr std::string_view kBoth[] = {"peel", "peel_dual"};

TEST_F(PeelTest, EqualsTheReferenceAndLosesNoFragment) {
  const glm::uvec2 picture{80, 45};
  for (const char* scene_id : {"street", "closeup", "fireball", "coloured", "glass", "sparks", "two_panes"}) {
    SCOPED_TRACE(scene_id);
    Stage stage(device, pipelines, library, library.scene(scene_id));
    const Targets targets(device, picture);
    stage.go_to(stage.scene().default_tick, picture);
    MethodInstance reference = instance("reference");
    const Image exact = draw(stage, targets, reference).linear;
    const uint32_t fragments =
        gpu::read<shared::FragmentPool>(device, reference.resources.buffer("pool"))[0].count;
    float brightest = 0;
    for (const glm::vec3& pixel : exact.pixels) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
    uint32_t passes = 0;
    for (const std::string_view id : kBoth) {
      SCOPED_TRACE(id);
      MethodInstance method = instance(id);
      EXPECT_LT(max_abs(exact, draw(stage, targets, method).linear).value, 1e-3 * double(brightest));
      const nlohmann::json told = method.method->statistics(device, method.resources);
      EXPECT_EQ(fragments, told["fragments"]);
      EXPECT_EQ(0u, told["dropped_fragments"]);
      EXPECT_EQ(0u, told["missed_fragments"]);
      const uint32_t deepest = told["deepest_pixel"];
      EXPECT_EQ(1 + (id == "peel" ? deepest : (deepest + 1) / 2), told["geometry_passes"]);
      passes += uint32_t(told["geometry_passes"]);
    }
    EXPECT_GT(passes, 4u) << "there is nothing to peel";
  }
}

TEST_F(PeelTest, CardsThatCrossEachOtherAreSortedAtEveryPixel) {
  size = {48, 32};
  Random random(5);
  for (int i = 0; i < 60; ++i)
    add({.z = i % 3 == 0 ? 6.0f : random.f(3, 9),
         .optical_depth = random.f(0.05, 2),
         .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
         .transmission = i % 4 == 0 ? glm::vec3(0.8f, 0.3f, random.f(0, 1)) : glm::vec3(0.0f),
         .emission = i % 5 == 0 ? glm::vec3(random.f(0, 2)) : glm::vec3(0.0f),
         .half_size = {random.f(0.5, 3), random.f(0.5, 3)},
         .at = {random.f(-3, 3), random.f(-2, 2)},
         .yaw = i % 3 == 0 ? 0.0f : random.f(-1.2, 1.2),
         .pitch = i % 3 == 0 ? 0.0f : random.f(-0.5, 0.5)});
  const Image exact = draw_cards("reference").linear;
  for (const std::string_view id : kBoth) {
    SCOPED_TRACE(id);
    const Drawn drawn = draw_peels(id);
    EXPECT_LT(max_abs(exact, drawn.linear).value, 1e-3);
    EXPECT_EQ(0u, drawn.statistics["missed_fragments"]);
    EXPECT_GT(drawn.statistics["deepest_pixel"], 10u);
  }
}

/// Every third card shares its depth with the next two.
class PeelTies : public PeelTest {
 protected:
  static constexpr uint32_t kCards = 21;
  void add_ties() {
    size = {16, 8};
    for (uint32_t i = 0; i < kCards; ++i)
      add_filling(4.0f + float(i / 3), 0.3f, {float(i % 3 == 0), float(i % 3 == 1), float(i % 3 == 2)});
  }
};

TEST_F(PeelTies, AllAreBlendedInTheOrderOfTheirCards) {
  add_ties();
  for (const std::string_view id : kBoth) {
    SCOPED_TRACE(id);
    const Drawn drawn = draw_peels(id);
    EXPECT_EQ(kCards, drawn.statistics["deepest_pixel"]);
    expect_everywhere(drawn.linear, composite([](size_t) { return true; }), 1.0 / 2048);
  }
}

/// A copy of the shaders with one of them changed.
class MutatedShaders {
 public:
  MutatedShaders(const std::string& shader, const std::string& from, const std::string& to) {
    std::filesystem::remove_all(folder_);
    std::filesystem::copy(PLUME_SOURCE_SHADERS, folder_, std::filesystem::copy_options::recursive);
    std::ostringstream text;
    text << std::ifstream(folder_ / shader).rdbuf();
    std::string source = text.str();
    const size_t at = source.find(from);
    if (at == std::string::npos) throw std::invalid_argument(shader + " does not have: " + from);
    std::ofstream(folder_ / shader) << source.replace(at, from.size(), to);
  }
  ~MutatedShaders() { std::filesystem::remove_all(folder_); }
  MutatedShaders(const MutatedShaders&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) / "plume_mutated_shaders";
};

TEST_F(PeelTies, AreLostAndTheLossIsToldWhenDepthsAloneAreCompared) {
  add_ties();
  const MutatedShaders mutated(
      "methods/peel/peel.frag", "if (key < nearest || key > farthest) return;",
      "if (nearest != kNearest && key != nearest && v_uv_depth.z <= depth_of(nearest)) "
      "return;");
  const gpu::Shaders compiled(mutated.folder());
  gpu::Pipelines with(device, compiled);
  MethodInstance method = instance("peel");
  const Drawn drawn = draw_peels(*world(), method, with);
  EXPECT_EQ(kCards * size.x * size.y, drawn.statistics["fragments"]);
  EXPECT_EQ(kCards / 3 * 2 * size.x * size.y, drawn.statistics["missed_fragments"]);
  // What is left is the first of each three.
  expect_everywhere(drawn.linear, composite([](size_t place) { return place % 3 == 0; }), 1.0 / 2048);
}

TEST_F(PeelTest, TrianglesThatStandOnEdgeAreFound) {
  // Their depth at a pixel is extrapolated over metres: what is tested and what is compared differ in more
  // than the last bits.
  for (const float half : {0.3f, 2.0f})
    for (uint32_t i = 0; i < 400; ++i) {
      const float yaw = 1.5f + 0.0003f * float(i);
      add({.z = 4.0f + 0.01f * float(i % 90),
           .optical_depth = 1.0f,
           .color = glm::vec3(0.001f * float(i)),
           .half_size = {half, 0.5f},
           .at = {-1.8f + 0.009f * float(i), 0.0f},
           .yaw = yaw});
    }
  size = {640, 24};
  for (const char* id : {"peel", "peel_dual"}) {
    const Drawn drawn = draw_peels(id);
    EXPECT_EQ(drawn.statistics.at("missed_fragments"), 0) << id;
    EXPECT_GT(drawn.statistics.at("fragments"), 20'000) << id;
  }
}

TEST_F(PeelTest, WhatTheLimitOfLayersDropsIsCounted) {
  size = {16, 8};
  for (int i = 0; i < 7; ++i)
    add_filling(4.0f + float(i), 0.4f, {0.1f * float(i), 1.0f - 0.1f * float(i), 0.5f});
  const uint32_t pixels = size.x * size.y;
  const Drawn front = draw_peels("peel", {{"layers", "3"}});
  EXPECT_EQ(4u, front.statistics["geometry_passes"]);
  EXPECT_EQ(4 * pixels, front.statistics["dropped_fragments"]);
  EXPECT_EQ(0u, front.statistics["missed_fragments"]);
  expect_everywhere(front.linear, composite([](size_t place) { return place < 3; }), 1.0 / 2048);
  // In pairs from both ends: three are four.
  const Drawn ends = draw_peels("peel_dual", {{"layers", "3"}});
  EXPECT_EQ(3u, ends.statistics["geometry_passes"]);
  EXPECT_EQ(3 * pixels, ends.statistics["dropped_fragments"]);
  EXPECT_EQ(0u, ends.statistics["missed_fragments"]);
  expect_everywhere(ends.linear, composite([](size_t place) { return place < 2 || place >= 5; }), 1.0 / 2048);
  // A limit that nothing reaches drops nothing.
  EXPECT_EQ(0u, draw_peels("peel", {{"layers", "7"}}).statistics["dropped_fragments"]);
}

TEST_F(PeelTest, RecordsMorePeelsWhenAPixelIsDeeperAndDrawsNoneTooMany) {
  size = {16, 8};
  for (int i = 0; i < 50; ++i) add_filling(4.0f + 0.1f * float(i), 0.05f, {0.5f, 0.02f * float(i), 0.3f});
  const glm::dvec3 exact = composite([](size_t) { return true; });
  MethodInstance method = instance("peel");
  const auto deep = world();
  const Drawn first = draw_peels(*deep, method, pipelines), second = draw_peels(*deep, method, pipelines);
  EXPECT_EQ(1u, first.redraws);
  EXPECT_EQ(0u, second.redraws);
  expect_everywhere(first.linear, exact, 1.0 / 2048);
  expect_everywhere(second.linear, exact, 1.0 / 2048);
  clear_cards();
  add_filling(5, 0.7f, {0.2f, 0.4f, 0.6f});
  const Drawn shallow = draw_peels(*world(), method, pipelines);
  EXPECT_EQ(2u, shallow.statistics["geometry_passes"]);
  const auto draws = gpu::read<shared::DrawCommand>(device, method.resources.buffer("draws"));
  ASSERT_GT(draws.size(), 80u) << "recorded for the deepest so far";
  for (size_t i = 0; i < draws.size(); ++i) ASSERT_EQ(i < 2 ? 1u : 0u, draws[i].instances);
  expect_everywhere(shallow.linear, composite([](size_t) { return true; }), 1.0 / 2048);
}

}  // namespace
}  // namespace plume
