// Tile-sorted compute against the reference, which draws: pixel by pixel, where cards are cut at their edges,
// where lists grow, and where pixels stop.
#include "sandbox/measure/metrics.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class TileSortedTest : public GpuTest {
 protected:
  static float brightest(const Image& image) {
    float most = 0.0f;
    for (const glm::vec3& pixel : image.pixels) most = std::max({most, pixel.r, pixel.g, pixel.b});
    return most;
  }
  /// Texture filters weigh in steps of 1/256: positions that differ in rounding fall to either side of one.
  static void expect_same_but_for_filtering(const Image& exact, const Image& tiles, const std::string& name) {
    EXPECT_LT(rmse(exact, tiles), 2e-4 * brightest(exact)) << name;
    EXPECT_LT(difference(exact, tiles), 5e-3 * brightest(exact)) << name;
  }
  static double difference(const Image& a, const Image& b) { return max_abs(a, b).value; }

  static Scene room() {
    Scene scene;
    scene.id = "room";
    scene.light.sky = false;
    scene.light.horizon = {0.2f, 0.3f, 0.5f};
    scene.tonemap = Tonemap::kNone;
    scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
    return scene;
  }
  struct Drawn {
    Image image;
    nlohmann::json statistics;
    uint32_t redraws;
  };
  Drawn draw_tiles(Stage& stage, uint32_t tick, glm::uvec2 size,
                   const std::map<std::string, std::string>& settings = {}) {
    const Targets targets(device, size);
    stage.go_to(tick, size);
    MethodInstance method = instance("tile_sorted", settings);
    const FrameReport report =
        render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method);
    return {read_picture(device, targets).linear, method.method->statistics(device, method.resources),
            report.redraws};
  }
};

TEST_F(TileSortedTest, SpritesAreThoseOfADraw) {
  for (const char* name : {"fireball", "closeup", "sparks"}) {
    const Scene scene = library.scene(name);
    Stage stage(device, pipelines, library, scene);
    const Image exact = draw(stage, scene.default_tick, {160, 90}, "reference").linear;
    const Drawn tiles = draw_tiles(stage, scene.default_tick, {160, 90});
    expect_same_but_for_filtering(exact, tiles.image, name);
    EXPECT_GT(tiles.statistics["cards_in_tiles"], 20) << name;
    EXPECT_EQ(0, tiles.statistics["tilted_cards"]) << name;
  }
}

TEST_F(TileSortedTest, GlassAndSpritesMeetAtEachPixelsDepth) {
  const Scene scene = library.scene("interleaved");  // a pane slants through both banks of smoke
  Stage stage(device, pipelines, library, scene);
  const Image exact = draw(stage, scene.default_tick, {160, 90}, "reference").linear;
  const Drawn tiles = draw_tiles(stage, scene.default_tick, {160, 90});
  expect_same_but_for_filtering(exact, tiles.image, "interleaved");
  EXPECT_EQ(1, tiles.statistics["tilted_cards"]);
  EXPECT_GT(tiles.statistics["tilted_fragments"], 500);
  // The control: an order of whole cards does not manage it.
  EXPECT_GT(difference(exact, draw(stage, scene.default_tick, {160, 90}, "sorted").linear), 0.01);
}

TEST_F(TileSortedTest, CardsThatFaceTheCameraAreCutWhereADrawCutsThem) {
  Scene scene = room();
  const auto pane = [](glm::vec3 at, glm::vec2 size, glm::vec3 color) {
    return Pane{.position = at, .size_m = size, .color = color, .coverage = 0.6f};
  };
  scene.panes = {pane({-0.313, 0.207, 0}, {1.531, 0.917}, {1, 0, 0}),
                 pane({0.411, -0.119, -1}, {2.113, 1.217}, {0, 1, 0}),
                 pane({3.1, 2.03, -2}, {1.3, 1.7}, {0, 0, 1}),  // beyond the picture's corner
                 pane({0.05, 0.01, 1}, {0.013, 4.0}, {1, 1, 1})};
  Stage stage(device, pipelines, library, scene);
  for (const glm::uvec2 size : {glm::uvec2(97, 61), glm::uvec2(16, 16), glm::uvec2(33, 47)}) {
    const Image exact = draw(stage, 0, size, "reference").linear;
    const Drawn tiles = draw_tiles(stage, 0, size);
    EXPECT_LT(difference(exact, tiles.image), 1e-3) << size.x;
    EXPECT_EQ(0, tiles.statistics["tilted_cards"]);
  }
}

TEST_F(TileSortedTest, CardsOfOneDepthKeepTheirOrder) {
  Scene scene = room();
  for (int i = 0; i < 40; ++i)
    scene.panes.push_back({.size_m = {40, 40}, .color = {i % 2, i % 3 == 0, i % 5 == 0}, .coverage = 0.1f});
  Stage stage(device, pipelines, library, scene);
  EXPECT_LT(difference(draw(stage, 0, {20, 20}, "reference").linear, draw_tiles(stage, 0, {20, 20}).image),
            1e-3);
}

TEST_F(TileSortedTest, ListsGrowInsteadOfTruncating) {
  Scene scene = room();
  for (int i = 0; i < 60; ++i)
    scene.panes.push_back({.position = {0, 0, -0.1f * float(i)},
                           .size_m = {400, 400},
                           .color = {0.5, 0.5, 0.5},
                           .coverage = 0.01f});
  Stage stage(device, pipelines, library, scene);
  const Image exact = draw(stage, 0, {320, 180}, "reference").linear;
  const Drawn tiles = draw_tiles(stage, 0, {320, 180});
  EXPECT_EQ(1u, tiles.redraws);
  EXPECT_EQ(60 * 20 * 12, tiles.statistics["list_entries"]);
  EXPECT_LT(difference(exact, tiles.image), 1e-3);
}

TEST_F(TileSortedTest, TheSizeOfTilesChangesNoPixel) {
  const Scene scene = library.scene("street");
  Stage stage(device, pipelines, library, scene);
  const Image first = draw_tiles(stage, 300, {160, 90}, {{"tile", "16"}}).image;
  for (const char* tile : {"32", "64"})
    EXPECT_EQ(0.0, difference(first, draw_tiles(stage, 300, {160, 90}, {{"tile", tile}}).image)) << tile;
}

TEST_F(TileSortedTest, APixelStopsWhenNothingBehindCanMatterAndNoSooner) {
  Scene scene = room();
  for (int i = 0; i < 30; ++i)
    scene.panes.push_back({.position = {0, 0, -0.2f * float(i)},
                           .size_m = {400, 400},
                           .color = {0.5, 0.5, 0.5},
                           .coverage = 0.5f});
  const auto stopped = [&](const Scene& drawn, const char* below) {
    Stage stage(device, pipelines, library, drawn);
    const Image exact = draw(stage, 0, {32, 32}, "reference").linear;
    const Drawn tiles = draw_tiles(stage, 0, {32, 32}, {{"stop_below", below}});
    EXPECT_LT(difference(exact, tiles.image), std::max(1e-3, std::atof(below)));
    return tiles.statistics["stopped_pixels"].get<int>();
  };
  EXPECT_EQ(1024, stopped(scene, "0.0001"));
  EXPECT_EQ(0, stopped(scene, "0"));
  // A lamp behind thirty halvings, bright enough to be seen through them: a threshold of transmittance alone
  // would lose it.
  scene.panes.push_back({.position = {0, 0, -8}, .size_m = {400, 400}, .coverage = 0});
  scene.panes.resize(31);
  for (int i = 0; i < 16; ++i) scene.panes.erase(scene.panes.begin());
  scene.panes.back().emission = glm::vec3(8000);
  EXPECT_EQ(0, stopped(scene, "0.0001"));
}

}  // namespace
}  // namespace plume
