// Classes of cards: nothing may be left out that is seen, and nothing be drawn without what lies in front of
// it.
#include "shaders/methods/avboit/card_class.h"
#include "shaders/methods/avboit/zero_tile.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

class AvboitClassify : public AvboitTest {
 protected:
  AvboitClassify() { size = {160, 96}; }
  avboit::Settings settings;
  Random random{1};

  /// The class of every card, from the sorted order and the indirect draws.
  std::vector<uint32_t> classes(const Stages& s) {
    const auto sorted = s.words("class_order"), draws = s.words("class_draws");
    std::vector<uint32_t> found(cards().size(), ~0u);
    for (uint32_t c = 0; c < shared::kClasses; ++c)
      for (uint32_t i = 0; i < draws[4 * c + 1]; ++i) {
        uint32_t& place = found[sorted[draws[4 * c + 3] + i]];
        EXPECT_EQ(~0u, place) << "listed twice";
        place = c;
      }
    const auto all = cards();
    for (size_t i = 0; i < all.size(); ++i) {
      const bool shows = all[i].optical_depth > 0 || all[i].emission != glm::uvec2(0);
      EXPECT_EQ(shows, found[i] != ~0u) << "card " << i;
      if (!shows) found[i] = shared::kClassUnseen;
    }
    return found;
  }
  static bool smooth(const shared::Card& card) { return (card.layers & 0xfff) == 0; }
};

TEST_F(AvboitClassify, EveryCardKnowsWhatLiesInFrontOfIt) {
  settings.zero_depth = avboit::ZeroDepth::kOff;
  settings.small_cells = 0;
  size_t behind_rgb = 0, behind_layers = 0, free_of_both = 0;
  for (int round = 0; round < 8; ++round) {
    clear_cards();
    for (int i = 0; i < 60; ++i) {
      const double z = random.octaves(2, 30);
      add({.z = float(z),
           .optical_depth = i == 7 ? 0.0f : float(random.octaves(0.06, 0.6)),
           .transmission = i % 10 == 0   ? glm::vec3(0.9f, 0.2f, 0.4f)
                           : i % 10 == 1 ? glm::vec3(0.5f)
                                         : glm::vec3(0.0f),
           .emission = i == 8 ? glm::vec3(1.0f) : glm::vec3(0.0f),
           .half_size = {z * random.octaves(0.02, 0.6), z * random.octaves(0.02, 0.4)},
           .at = {z * random.between(-1, 1), z * random.between(-0.6, 0.6)},
           .yaw = i % 2 ? 0.0f : random.f(-1.4, 1.4),
           .layer = i % 9 == 0 ? shared::kSolidLayer : 0});
    }
    const Stages s = run_stages(settings, Until::kClassify);
    const auto found = classes(s);
    const auto all = cards();
    std::vector<uint32_t> needed(all.size());
    std::vector<std::pair<double, size_t>> on_ray;
    for (uint32_t y = 0; y < size.y; y += 2)
      for (uint32_t x = 0; x < size.x; x += 2) {
        on_ray.clear();
        for (size_t id = 0; id < all.size(); ++id)
          if (const auto z = hit(all[id], glm::dvec2(x, y) + 0.5); z && all[id].optical_depth > 0)
            on_ray.push_back({*z, id});
        for (const auto& [z, id] : on_ray)
          for (const auto& [other_z, other] : on_ray)
            if (other_z < z * 0.9999)
              needed[id] |= !smooth(all[other])      ? shared::kBehindLayers
                            : other >= scalar.size() ? shared::kBehindRgb
                                                     : 0u;
      }
    for (size_t id = 0; id < all.size(); ++id) {
      const bool seen =
          bounds_of(all[id], view()).seen && (all[id].optical_depth > 0 || all[id].emission.x != 0);
      ASSERT_EQ(!seen, found[id] >= shared::kClassUnseen && found[id] != 4 * shared::kKindExact + 2 &&
                           found[id] != 4 * shared::kKindExact + 3)
          << "card " << id;
      if (!seen) continue;
      const uint32_t kind = found[id] / 4, bits = found[id] % 4;
      const bool shines = all[id].optical_depth == 0;
      const bool faces =
          all[id].axis_u.z == 0 && all[id].axis_v.z == 0 && all[id].transmission == glm::uvec2(0);
      ASSERT_EQ(!smooth(all[id]) || shines ? shared::kKindExact
                : id >= scalar.size()      ? shared::kKindRgb
                : faces                    ? shared::kKindPlain
                                           : shared::kKindGeneral,
                kind)
          << "card " << id;
      ASSERT_EQ(needed[id], needed[id] & bits) << "card " << id << " does not know what is in front of it";
      behind_rgb += (bits & shared::kBehindRgb) != 0;
      behind_layers += (bits & shared::kBehindLayers) != 0 && kind != shared::kKindExact;
      free_of_both += bits == 0;
    }
  }
  EXPECT_GT(behind_rgb, 10u);
  EXPECT_GT(behind_layers, 10u);
  EXPECT_GT(free_of_both, 10u) << "everything counts as behind everything";
}

TEST_F(AvboitClassify, ACardIsLeftOutOnlyWhereItIsWhollyBehindTheZeroDepth) {
  // A bank of opaque smoke in the left two thirds, small cards before and behind it.
  for (int i = 0; i < 30; ++i)
    add({.z = 8 + 0.05f * float(i), .optical_depth = 0.5f, .half_size = {8, 30}, .at = {-6, 0}});
  for (int i = 0; i < 150; ++i) {
    const double z = random.octaves(4, 20);
    add({.z = float(z),
         .optical_depth = 0.1f,
         .half_size = glm::vec2(float(z) * 0.03f),
         .at = {z * random.between(-0.8, 0.8), z * random.between(-0.5, 0.5)},
         .yaw = i % 3 ? 0.0f : random.f(-1.4, 1.4)});
  }
  const Stages s = run_stages(settings, Until::kClassify);
  const auto found = classes(s);
  const auto depths = gpu::read<float>(device, s.resources.buffer("zero_depths"));
  const uint32_t across = (size.x + 15) / 16;
  size_t left_out = 0, kept_behind = 0;
  for (size_t id = 30; id < scalar.size(); ++id) {
    if (!bounds_of(scalar[id], view()).seen) continue;
    bool seen = false;
    for (uint32_t y = 0; y < size.y; ++y)
      for (uint32_t x = 0; x < size.x; ++x)
        if (const auto z = hit(scalar[id], glm::dvec2(x, y) + 0.5))
          seen = seen || double(view().near_m) / *z > double(depths[y / 16 * across + x / 16]) * 1.00001;
    const bool out = found[id] == shared::kClassUnseen;
    ASSERT_FALSE(out && seen) << "card " << id << " at " << -scalar[id].center.z
                              << " m is in front of the zero depth";
    left_out += out;
    kept_behind += !out && !seen;
  }
  EXPECT_GT(left_out, 15u);
  EXPECT_GT(left_out, kept_behind / 2) << "too few of those that could be left out are";
}

}  // namespace
}  // namespace plume
