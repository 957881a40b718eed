// Who sorts what: the orders of sorted blending against the reference, where emitters mix and where they do
// not.
#include "sandbox/measure/metrics.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{160, 90};
constexpr const char* kByEmitter[] = {"artist", "cpu", "gpu_emitter"};

class SortedOrderTest : public GpuTest {
 protected:
  double error(const Scene& scene, const std::string& order) {
    Stage stage(device, pipelines, library, scene);
    const uint32_t tick = scene.default_tick;
    const Image exact = draw(stage, tick, kSize, "reference").linear;
    return rmse(exact, draw(stage, tick, kSize, "sorted", {{"order", order}}).linear);
  }
  /// The two banks of smoke of the shipped scene, without the glass.
  Scene two_banks(glm::vec3 teal, glm::vec3 rust) {
    Scene scene = library.scene("interleaved");
    scene.panes.clear();
    scene.light.self_shadow = false;  // a bank in the other's shadow is dark: its order hardly shows
    scene.instances[0].position = teal;
    scene.instances[1].position = rust;
    return scene;
  }
  static Scene room() {
    Scene scene;
    scene.id = "room";
    scene.light.sky = false;
    scene.light.horizon = {0, 0, 0};
    scene.tonemap = Tonemap::kNone;
    scene.camera = {{.tick = 0, .position = {0, 0, 5}, .target = {0, 0, 0}, .vertical_fov_deg = 50}};
    return scene;
  }
  static Pane pane(float z, glm::vec3 color, int draw_order) {
    Pane pane{.position = {0, 0, z}, .size_m = {40, 40}, .color = color, .coverage = 0.5f};
    pane.draw_order = draw_order;
    return pane;
  }
  glm::vec3 middle(const Scene& scene, const std::string& order) {
    Stage stage(device, pipelines, library, scene);
    const Image image = draw(stage, 0, {5, 5}, "sorted", {{"order", order}}).linear;
    return image.pixels[12];
  }
};

TEST_F(SortedOrderTest, InterleavedEmittersAreRightOnlyWhenAllCardsAreSortedTogether) {
  const Scene scene = two_banks({-0.25, 0, 0.15}, {0.25, 0, -0.15});
  const double together = error(scene, "gpu_all");
  RecordProperty("gpu_all", std::to_string(together));
  EXPECT_LT(together, 0.002);
  for (const std::string order : kByEmitter) {
    const double apart = error(scene, order);
    RecordProperty(order, std::to_string(apart));
    EXPECT_GT(apart, 10 * together) << order;
    EXPECT_GT(apart, 0.01) << order;
  }
}

// The control: the same smoke side by side in depth.
TEST_F(SortedOrderTest, EmittersBehindEachOtherAreRightWithAGpuSortInsideThem) {
  Scene scene = two_banks({0, 0, 2.0}, {0, 0, -2.0});  // rust is behind, as its draw_order says
  EXPECT_LT(error(scene, "gpu_emitter"), 0.002);
  // The oldest first is no order of depth.
  for (const std::string order : {"artist", "cpu"}) EXPECT_GT(error(scene, order), 0.004) << order;
  EXPECT_NEAR(error(scene, "artist"), error(scene, "cpu"), 1e-9);
}

TEST_F(SortedOrderTest, AnArtistCanPutTheFarEmitterInFront) {
  Scene scene = two_banks({0, 0, -2.0}, {0, 0, 2.0});  // rust is in front and drawn first
  EXPECT_GT(error(scene, "artist"), 2 * error(scene, "cpu"));
  scene.instances[1].draw_order = 3;  // of the instance, added to that of its emitter: now above teal's
  EXPECT_NEAR(error(scene, "artist"), error(scene, "cpu"), 1e-9);
}

TEST_F(SortedOrderTest, PanesAreDrawnInTheOrderThatEachModeSays) {
  const glm::vec3 red{1, 0, 0}, green{0, 1, 0};
  Scene scene = room();
  scene.panes = {pane(0, red, 5), pane(-3, green, 7)};
  for (const std::string order : {"cpu", "gpu_emitter", "gpu_all"}) {
    EXPECT_NEAR(middle(scene, order).r, 0.5f, 1e-3) << order;
    EXPECT_NEAR(middle(scene, order).g, 0.25f, 1e-3) << order;
  }
  EXPECT_NEAR(middle(scene, "artist").r, 0.25f, 1e-3);
  EXPECT_NEAR(middle(scene, "artist").g, 0.5f, 1e-3);
  scene.panes[1].draw_order = 5;  // equal: as they stand in the scene, the last on top
  EXPECT_NEAR(middle(scene, "artist").g, 0.5f, 1e-3);
  scene.panes[1].draw_order = -5;
  EXPECT_NEAR(middle(scene, "artist").g, 0.25f, 1e-3);
}

TEST_F(SortedOrderTest, GlassThatCrossesIsWrongInEveryOrder) {
  Scene scene = library.scene("glass");
  for (const std::string order : {"artist", "cpu", "gpu_emitter", "gpu_all"}) {
    const double crossing = error(scene, order);
    RecordProperty(order, std::to_string(crossing));
    EXPECT_GT(crossing, 0.005) << order;
  }
  // The control: without the three that cross others, what is left has an order.
  Scene apart = scene;
  apart.panes = {scene.panes[0], scene.panes[2], scene.panes[4], scene.panes[6],
                 scene.panes[7], scene.panes[8], scene.panes[9]};
  EXPECT_LT(error(apart, "gpu_all"), 0.001);
}

TEST_F(SortedOrderTest, SpritesThroughASlantingPaneAreWrongEvenWhenAllCardsAreSorted) {
  Scene scene = library.scene("interleaved");
  const double through = error(scene, "gpu_all");
  scene.panes.clear();
  const double without = error(scene, "gpu_all");
  RecordProperty("through_glass", std::to_string(through));
  RecordProperty("without", std::to_string(without));
  EXPECT_GT(through, 5 * without);
}

TEST_F(SortedOrderTest, EveryCardIsDrawnOnceWhateverTheOrder) {
  // Where nothing but light is added, no order matters: all four pictures are one.
  Scene scene = room();
  for (int i = 0; i < 7; ++i) {
    scene.panes.push_back(pane(float(i % 3) - float(i), {0, 0, 0}, i % 2));
    scene.panes.back().coverage = 0;
    scene.panes.back().emission = glm::vec3(float(1 << i) / 128.0f);
  }
  scene.panes[2].transmission = scene.panes[5].transmission = {0.5, 0.2, 0.1};  // of the other source
  for (const std::string order : {"artist", "cpu", "gpu_emitter", "gpu_all"})
    EXPECT_NEAR(middle(scene, order).r, 127.0f / 128, 1e-3) << order;
}

}  // namespace
}  // namespace plume
