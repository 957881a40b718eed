// Draws in any order leave the same bits: in the volume always, in the picture where integers are added up.
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

constexpr uint32_t kOrders = 20;

class AvboitDeterministic : public AvboitTest {
 protected:
  Random random{3};
  /// Smoke, glass, fire and near-opaque cards, some of one depth, and more sharp ones than layers.
  void add_everything() {
    scene.light.horizon = {0.3f, 0.5f, 0.7f};
    for (int i = 0; i < 60; ++i) {
      const double z = i % 5 == 0 ? 4.0 : random.octaves(1, 30);
      const bool glass = i % 4 == 1;
      add({.z = float(z),
           .optical_depth = random.f(0.05, i % 6 == 0 ? 7 : 0.8),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .transmission =
               glass ? glm::vec3(random.f(0, 1), random.f(0, 1), random.f(0, 1)) : glm::vec3(0.0f),
           .emission = i % 7 == 3 ? glm::vec3(random.f(0, 40)) : glm::vec3(0.0f),
           .half_size = {z * random.octaves(0.1, 2), z * random.octaves(0.1, 2)},
           .at = {z * random.between(-0.5, 0.5), z * random.between(-0.3, 0.3)},
           .yaw = i % 3 == 0 ? random.f(-1, 1) : 0.0f,
           .layer = glass || i % 8 == 2 ? shared::kSolidLayer : shared::kSoftLayer});
    }
  }
  /// Another order of draws each time: each source among its own.
  void shuffle() {
    order.resize(scalar.size() + rgb.size());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<uint32_t> first(order.begin(), order.begin() + ptrdiff_t(scalar.size())),
        second(order.begin() + ptrdiff_t(scalar.size()), order.end());
    random.shuffle(first), random.shuffle(second);
    std::ranges::copy(second, std::ranges::copy(first, order.begin()).out);
  }
};

TEST_F(AvboitDeterministic, TheVolumeIsTheSameBitsInEveryOrderOfDraws) {
  for (const avboit::Splat splat : {avboit::Splat::kPacked16Overflow, avboit::Splat::kWords32,
                                    avboit::Splat::kPacked8Exchange, avboit::Splat::kPacked8Overflow}) {
    clear_cards();
    add_everything();
    avboit::Settings settings;
    settings.splat = splat;
    const auto left = [&] {
      const Stages s = run_stages(settings, Until::kClassify);
      std::map<std::string, std::vector<uint32_t>> found;
      for (const char* name : {"extinction", "extinction_rgb", "overflow", "occupancy", "warp", "layers",
                               "layer_tails", "zero_slice"})
        found[name] = s.words(name);
      return found;
    };
    const auto first = left();
    EXPECT_GT(std::ranges::count_if(first.at("extinction"), [](uint32_t word) { return word != 0; }), 100);
    for (uint32_t i = 0; i < kOrders; ++i) {
      shuffle();
      for (const auto& [name, words] : left())
        EXPECT_TRUE(first.at(name) == words) << name << " in order " << i << ", splat " << int(splat);
    }
  }
}

TEST_F(AvboitDeterministic, ThePictureIsTheSameBitsInEveryOrderOfDraws) {
  for (const char* half : {"false", "true"}) {
    for (const char* colour : {"rgb", "skew", "mono"}) {
      clear_cards();
      add_everything();
      const std::map<std::string, std::string> integers{
          {"accumulation", "deterministic"}, {"half_particles", half}, {"colour", colour}};
      const auto first = draw_cards("avboit", integers).linear.pixels;
      for (uint32_t i = 0; i < kOrders; ++i) {
        shuffle();
        EXPECT_TRUE(first == draw_cards("avboit", integers).linear.pixels)
            << "order " << i << ", half_particles " << half << ", colour " << colour;
      }
    }
  }
}

TEST_F(AvboitDeterministic, ThePictureIsThatOfFloatsButForRounding) {
  for (const char* half : {"false", "true"})
    for (const char* colour : {"rgb", "first_event", "skew", "total_extinction", "mono"})
      for (const char* doubt : {"false", "true"}) {
        SCOPED_TRACE(testing::Message() << "half " << half << ", " << colour << ", doubt " << doubt);
        clear_cards();
        add_everything();
        std::map<std::string, std::string> settings{
            {"accumulation", "32f"}, {"half_particles", half}, {"colour", colour}, {"weigh_doubt", doubt}};
        const auto floats = draw_cards("avboit", settings).linear.pixels;
        settings["accumulation"] = "deterministic";
        const auto integers = draw_cards("avboit", settings).linear.pixels;
        // The picture is half floats: a step of them, of what may be 40 bright.
        for (size_t i = 0; i < floats.size(); ++i)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(floats[i][c], integers[i][c], 2e-3f * std::max(1.0f, floats[i][c])) << "pixel " << i;
      }
}

TEST_F(AvboitDeterministic, OpaqueCardsLetNothingThrough) {
  scene.light.horizon = glm::vec3(1e4f);
  add({.z = 5, .optical_depth = shared::kOpaqueDepth, .layer = shared::kSoftLayer});
  for (const glm::vec3& pixel : draw_cards("avboit", {{"accumulation", "deterministic"}}).linear.pixels)
    ASSERT_EQ(glm::vec3(0.0f), pixel);
}

}  // namespace
}  // namespace plume
