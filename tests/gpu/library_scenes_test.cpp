// Scenes of the library that are there to show one thing: that they do, in numbers.
#include <cmath>

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{160, 90};

double luminance(glm::vec3 c) {
  return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
}

class LibraryScenes : public GpuTest {
 protected:
  using Map = std::map<std::string, std::string>;
  Image shot(const Scene& scene, std::string_view id, const Map& settings = {}) {
    Stage stage(device, pipelines, library, scene);
    return draw(stage, scene.default_tick, kSize, id, settings).linear;
  }
};

class FireballLayers : public LibraryScenes {
 protected:
  /// The left fireball alone, its core where it is or as far towards the camera as the effect says.
  Scene fireball(bool offset) {
    Scene scene = library.scene("fireball_layers");
    scene.instances.resize(1);
    const Layer core = library.effect(scene.instances[0].effect).layers.at(0);
    scene.instances[0].layers = {
        {.layer = core.name, .camera_offset_m = offset ? core.camera_offset_m : 0.0f, .at = {}}};
    return scene;
  }
};

TEST_F(FireballLayers, TheCoreHidesInItsSmokeUnlessItIsDrawnAfterItOrNearer) {
  const Image by_hand = shot(fireball(false), "sorted", {{"order", "artist"}});
  // The core is what shines when an artist draws it after the smoke.
  std::vector<size_t> core;
  for (size_t i = 0; i < by_hand.pixels.size(); ++i)
    if (by_hand.pixels[i].r > 0.6f) core.push_back(i);
  ASSERT_GT(core.size(), 300u);
  struct Seen {
    double light = 0, error = 0;  // means over the core: luminance, and its difference from the artist's
  };
  const auto seen = [&](const Image& image) {
    Seen mean;
    for (const size_t i : core) {
      const double light = luminance(image.pixels[i]);
      mean.light += light / double(core.size());
      mean.error += std::abs(light - luminance(by_hand.pixels[i])) / double(core.size());
    }
    return mean;
  };
  const double wanted = seen(by_hand).light;
  for (const char* id : {"reference", "avboit"}) {
    SCOPED_TRACE(id);
    const Seen plain = seen(shot(fireball(false), id)), offset = seen(shot(fireball(true), id));
    RecordProperty(id, std::to_string(wanted) + " by hand, " + std::to_string(plain.light) + " plain, " +
                           std::to_string(offset.light) + " offset; error " + std::to_string(plain.error) +
                           " plain, " + std::to_string(offset.error) + " offset");
    EXPECT_LT(plain.light, 0.3 * wanted) << "hidden";
    EXPECT_GT(offset.light, 0.7 * wanted) << "shown";
    EXPECT_LT(offset.light, 1.2 * wanted);
    EXPECT_LT(offset.error, 0.5 * plain.error) << "nearer to what the artist drew, pixel by pixel";
  }
}

TEST_F(LibraryScenes, GlassRowPassesTheProductOfItsTints) {
  Scene scene = library.scene("glass_row");
  const std::vector<Pane> panes = scene.panes;  // nearest first
  ASSERT_EQ(panes.size(), 8u);
  const Image reference = shot(scene, "reference"), avboit = shot(scene, "avboit"),
              one_colour = shot(scene, "avboit", {{"colour", "mono"}, {"exact_layers", "0"}});
  scene.panes.clear();
  const Image ground = shot(scene, "reference");
  double worst_of_one_colour = 0;
  for (size_t k = 0; k <= 8; ++k) {
    SCOPED_TRACE(testing::Message() << "through " << k);
    // The middle of column k, over the balls and under the upper edges.
    const int x = int(0.5f * float(kSize.x) * (1 - 0.76f + 0.19f * float(k) - 0.095f)), y = 33;
    glm::vec3 expected = ground.at(x, y);
    for (size_t i = k; i-- > 0;) expected = panes[i].color + panes[i].transmission * expected;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(reference.at(x, y)[c], expected[c], 1e-3);
      EXPECT_NEAR(avboit.at(x, y)[c], expected[c], 2.0 / 255);
      worst_of_one_colour =
          std::max(worst_of_one_colour, std::abs(double(one_colour.at(x, y)[c]) - expected[c]));
    }
  }
  EXPECT_GT(worst_of_one_colour, 10.0 / 255) << "a positive control: one transmittance for all colours";
}

TEST_F(LibraryScenes, ThinLayersLookAlikeHoweverManyTheyAre) {
  Scene scene = library.scene("thin_layers");
  const std::vector<Pane> panes = scene.panes;  // of each field nearest first
  const size_t counts[] = {6, 24, 96};
  ASSERT_EQ(panes.size(), 6u + 24u + 96u);
  const Image reference = shot(scene, "reference"), avboit = shot(scene, "avboit"),
              lanes = shot(scene, "avboit", {{"exact_layers", "0"}, {"splat", "packed8"}}),
              dithered =
                  shot(scene, "avboit", {{"exact_layers", "0"}, {"splat", "packed8"}, {"dither", "true"}});
  scene.panes.clear();
  const Image ground = shot(scene, "reference");
  size_t first = 0;
  glm::vec3 dark[3];  // of each field, in front of a bar
  double lanes_error = 0, dithered_error = 0;
  for (int field = 0; field < 3; ++field) {
    const std::span<const Pane> layers(&panes[first], counts[field]);
    first += counts[field];
    for (int y = 25; y < 65; ++y)
      for (int x = 60 + 52 * (field - 1); x < 100 + 52 * (field - 1); ++x) {
        glm::vec3 expected = ground.at(x, y);
        for (size_t i = layers.size(); i-- > 0;)
          expected = glm::mix(expected, layers[i].color, layers[i].coverage);
        if (ground.at(x, y).r < 0.05f) dark[field] = expected;
        for (int c = 0; c < 3; ++c) {
          ASSERT_NEAR(reference.at(x, y)[c], expected[c], 2e-3) << field << ": " << x << ", " << y;
          ASSERT_NEAR(avboit.at(x, y)[c], expected[c], 6.0 / 255) << field << ": " << x << ", " << y;
        }
        if (field < 2) continue;
        lanes_error += std::abs(lanes.at(x, y).r - expected.r) / (40.0 * 40.0);
        dithered_error += std::abs(dithered.at(x, y).r - expected.r) / (40.0 * 40.0);
      }
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(dark[0][c], dark[1][c], 3.0 / 255);
    EXPECT_NEAR(dark[1][c], dark[2][c], 1.0 / 255);
  }
  RecordProperty("lanes", std::to_string(lanes_error) + ", dithered " + std::to_string(dithered_error));
  EXPECT_GT(lanes_error, 3 * dithered_error) << "a positive control: layers under half a step of 8 bits";
}

TEST_F(LibraryScenes, InWorldUiInSmokeIsReadOnceItsLayersAreBroughtForward) {
  Scene scene = library.scene("in_world_ui");
  Scene in_place = scene, clear = scene;
  std::erase_if(clear.instances, [](const Instance& instance) { return instance.effect != "marker"; });
  const auto marker = std::ranges::find(in_place.instances, "marker_before_smoke", &Instance::name);
  ASSERT_NE(marker, in_place.instances.end());
  ASSERT_EQ(marker->layers.size(), 3u);
  marker->layers.clear();
  const Image without_smoke = shot(clear, "reference");
  for (const char* id : {"reference", "avboit"}) {
    SCOPED_TRACE(id);
    const Image forward = shot(scene, id), there = shot(in_place, id);
    double forward_changes = 0, there_changes = 0;
    int marks = 0;
    for (int y = 0; y < int(kSize.y); ++y)
      for (int x = int(kSize.x) / 2; x < int(kSize.x); ++x) {  // the right one of the two markers
        const glm::vec3 c = without_smoke.at(x, y);
        const bool green = c.g > 0.5f && c.r < 0.2f && c.b < 0.3f;  // what is left on the bar
        if (!green) continue;
        ++marks;
        forward_changes += std::abs(luminance(forward.at(x, y)) - luminance(c));
        there_changes += std::abs(luminance(there.at(x, y)) - luminance(c));
      }
    ASSERT_GT(marks, 10);
    EXPECT_LT(forward_changes / marks, 0.1);
    EXPECT_GT(there_changes, 3 * forward_changes);
  }
}

TEST_F(LibraryScenes, EmptyNeedsNothingAndChangesNothing) {
  Stage stage(device, pipelines, library, library.scene("empty"));
  const Targets targets(device, {48, 27}, stage.post());
  stage.go_to(stage.scene().duration_ticks, targets.size);
  EXPECT_TRUE(stage.demand().empty());
  EXPECT_EQ(stage.transparents().count, 0u);
  MethodInstance reference = instance("reference");
  const Image opaque = draw(stage, targets, reference).linear;
  for (const std::string& id : method_ids()) {
    MethodInstance method = instance(id);
    if (!method.method->missing(device).empty()) continue;
    EXPECT_TRUE(draw(stage, targets, method).linear.pixels == opaque.pixels) << id;
  }
}

}  // namespace
}  // namespace plume
