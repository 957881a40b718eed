// Occupancy: every slice of every tile that a fragment writes or reads has its bit, against cards rasterised
// here; and what has no bit is never looked at.
#include <algorithm>

#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

class AvboitOccupancy : public AvboitTest {
 protected:
  AvboitOccupancy() {
    size = {150, 90};  // 19 x 12 cells of 8: three tiles by two, the last ones in part
    settings.exact_layers = 0;
  }
  avboit::Settings settings;
  Random random{1};

  void add_random_cards(int count) {
    for (int i = 0; i < count; ++i) {
      const double z = random.octaves(0.2, 40);
      add({.z = float(z),
           .optical_depth = random.f(0.1, 2),
           .transmission = i % 3 == 0 ? glm::vec3(0.9f, 0.2f, 0.4f) : glm::vec3(0.0f),
           .half_size = {z * random.octaves(0.02, 1), z * random.octaves(0.02, 1)},
           .at = {z * random.between(-0.9, 0.9), z * random.between(-0.6, 0.6)},
           .yaw = random.f(-3, 3),
           .pitch = random.f(-1.5, 1.5)});
    }
  }

  struct Masks {
    const std::vector<uint32_t> words;
    shared::Volume v;
    bool has(bool of_rgb, glm::uvec2 cell, uint32_t slice) const {
      const glm::uvec2 tile = cell / shared::kTileCells;
      const uint32_t at = (of_rgb ? v.tiles.x * v.tiles.y : 0) + tile.y * v.tiles.x + tile.x;
      return words[at * shared::kMaskWords + slice / 32] >> slice % 32 & 1;
    }
  };

  /// How far from the end of a slice a depth must be for single precision to agree about which slice it is
  /// in.
  static constexpr double kMargin = 0.01;
  static void each_slice(double from, double to, const shared::Volume& v,
                         const std::function<void(uint32_t)>& f) {
    for (double s = std::floor(from + kMargin); s <= std::floor(to - kMargin); ++s)
      f(uint32_t(std::clamp(s, 0.0, double(v.slices - 1))));
  }

  /// Every write of the splat and every read of the draw, from the cards.
  void expect_conservative() {
    const Stages s = run_stages(settings, Until::kOccupancy);
    const shared::Volume& v = s.volume();
    const Warp warp = s.warp();
    const Masks masks{s.words("occupancy"), v};
    const auto all = cards();
    size_t writes = 0, reads = 0;
    for (size_t id = 0; id < all.size(); ++id) {
      const bool of_rgb = s.plan.rgb && id >= scalar.size();
      SCOPED_TRACE(testing::Message() << "card " << id << " at " << all[id].center.z);
      for (uint32_t y = 0; y < v.cells.y; ++y)
        for (uint32_t x = 0; x < v.cells.x; ++x)
          if (const auto z = hit(all[id], (glm::dvec2(x, y) + 0.5) * double(v.divisor))) {
            const double p = slice_at(v, warp, *z);
            each_slice(p, settings.linear_splat ? p + 1 : p, v, [&](uint32_t slice) {
              ++writes;
              ASSERT_TRUE(masks.has(of_rgb, {x, y}, slice))
                  << "written at " << x << " " << y << " slice " << slice;
            });
          }
      for (uint32_t y = 0; y < size.y; ++y)
        for (uint32_t x = 0; x < size.x; ++x)
          if (const auto z = hit(all[id], glm::dvec2(x, y) + 0.5)) {
            const double p = slice_at(v, warp, *z);
            const glm::dvec2 cell = (glm::dvec2(x, y) + 0.5) / double(v.divisor) - 0.5;
            double from = p, to = p;
            using avboit::Sampling;
            if (settings.sampling == Sampling::kSelfExcluded)
              from = to = settings.linear_splat ? p + 0.5 : p;
            else if (settings.sampling == Sampling::kPoint)
              from = to = std::floor(p) - double(settings.bias) + 0.5;
            else if (settings.sampling == Sampling::kLinear)
              from = to = p + 1 - double(settings.bias);
            else
              from = p - double(settings.bias), to = p + 2 - double(settings.bias);
            for (int corner = 0; corner < 4; ++corner) {
              const glm::uvec2 read(glm::clamp(glm::floor(cell) + glm::dvec2(corner & 1, corner >> 1),
                                               glm::dvec2(0), glm::dvec2(v.cells - 1u)));
              each_slice(from, to, v, [&](uint32_t slice) {
                ++reads;
                ASSERT_TRUE(masks.has(false, read, slice) || masks.has(true, read, slice))
                    << "read at cell " << read.x << " " << read.y << " slice " << slice;
              });
            }
          }
      if (HasFatalFailure()) return;
    }
    EXPECT_GT(writes, 300u);
    EXPECT_GT(reads, 5000u);
  }
};

TEST_F(AvboitOccupancy, HasABitForEveryWriteAndEveryRead) {
  using avboit::Sampling;
  for (const Sampling sampling :
       {Sampling::kSelfExcluded, Sampling::kPoint, Sampling::kLinear, Sampling::kQuadratic, Sampling::kCubic})
    for (const bool linear : {true, false}) {
      SCOPED_TRACE(testing::Message() << "sampling " << int(sampling) << " linear splat " << linear);
      settings.sampling = sampling;
      settings.linear_splat = linear;
      settings.bias = sampling >= Sampling::kQuadratic ? 2.5f : linear ? 2.0f : 0.0f;
      settings.resolution = linear ? 2 : 1;
      settings.slices = linear ? 2 : 0;
      clear_cards();
      add_random_cards(48);
      expect_conservative();
      if (HasFatalFailure()) return;
    }
}

TEST_F(AvboitOccupancy, KeepsScalarAndRgbSourcesApart) {
  add({.z = 6, .half_size = {0.2f, 0.2f}, .at = {-3, 0}});
  add({.z = 9, .transmission = {1, 0, 0}, .half_size = {0.2f, 0.2f}, .at = {5, 0}});
  const Stages s = run_stages(settings, Until::kOccupancy);
  const Warp warp = s.warp();
  const Masks masks{s.words("occupancy"), s.volume()};
  const uint32_t near = uint32_t(slice_at(s.volume(), warp, 6)),
                 far = uint32_t(slice_at(s.volume(), warp, 9));
  ASSERT_NE(near, far);
  const glm::uvec2 left{4, 5}, right{15, 5};
  EXPECT_TRUE(masks.has(false, left, near));
  EXPECT_TRUE(masks.has(true, right, far));
  for (const bool of_rgb : {false, true})
    for (uint32_t slice = 0; slice < 128; ++slice) {
      EXPECT_FALSE(masks.has(of_rgb, of_rgb ? left : right, slice)) << "far from what is there";
      const uint32_t own = of_rgb ? far : near;
      if (masks.has(of_rgb, of_rgb ? right : left, slice)) {
        EXPECT_LE(slice, own + 1);
        EXPECT_GE(slice, own);
      }
    }
}

TEST_F(AvboitOccupancy, SharpCardsStartTheLayersOfTheirTiles) {
  settings.exact_layers = 2;
  add({.z = 6, .half_size = {0.2f, 0.2f}, .at = {-3, 0}, .layer = shared::kSolidLayer});
  add({.z = 7, .half_size = {0.2f, 0.2f}, .at = {-3, 0}, .layer = shared::kSolidLayer});
  add({.z = 4, .half_size = {0.2f, 0.2f}, .at = {3, 0}});
  settings.small_cells = 0;
  const Stages s = run_stages(settings, Until::kOccupancy);
  const auto start = s.words("layers_start");
  float left;
  std::memcpy(&left, &start[0], 4);
  EXPECT_FLOAT_EQ(6.0f, left);
  EXPECT_EQ(shared::kNoSlice, start[2]) << "smooth cards are in the volume";
}

/// Smoke-like cards over a wall, glass before and behind, something for every class of draw.
class AvboitSparse : public AvboitOccupancy {
 protected:
  void SetUp() override {
    size = {96, 52};
    Solid wall;
    wall.position = {6, 0, -12};
    wall.size_m = {10, 6, 1};
    scene.solids = {wall};
    scene.light.horizon = {0.2f, 0.3f, 0.4f};
    for (int i = 0; i < 90; ++i)
      add({.z = float(random.octaves(3, 20)),
           .optical_depth = float(random.octaves(0.05, 3)),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .transmission = i % 8 == 0   ? glm::vec3(0.9f, 0.2f, 0.4f)
                           : i % 8 == 1 ? glm::vec3(0.5f)
                                        : glm::vec3(0.0f),
           .emission = i % 9 == 0 ? glm::vec3(0.5f) : glm::vec3(0.0f),
           .half_size = {random.octaves(0.2, 2), random.octaves(0.2, 2)},
           .at = {random.f(-8, 8), random.f(-4, 4)},
           .yaw = i % 2 ? 0.0f : random.f(-1.5, 1.5),
           .pitch = i % 2 ? 0.0f : random.f(-1, 1),
           .layer = i % 5 == 0 ? shared::kSolidLayer : 0,
           .apart = i % 30 == 0});
    // Cards that face the camera at depths where slices begin, to single precision.
    for (int i = 0; i < 30; ++i)
      add({.z = 2.0f * (std::exp2(float(i + 20) * std::log2(401.0f) / 128.0f) - 1.0f),
           .optical_depth = 0.1f,
           .half_size = {1, 1}});
  }
  using Map = std::map<std::string, std::string>;
  static std::vector<Map> variants() {
    std::vector<Map> all;
    for (const char* sampling : {"self_excluded", "point", "linear", "quadratic", "cubic"})
      for (const char* linear : {"true", "false"})
        all.push_back(
            {{"sampling", sampling}, {"linear_splat", linear}, {"bias", sampling[0] == 'q' ? "2.5" : "2"}});
    all.push_back({{"splat", "packed8_overflow"}, {"rgb_splat", "packed10"}});
    all.push_back({{"splat", "words32"}, {"resolution", "1/2"}, {"exact_layers", "0"}});
    all.push_back({{"colour", "skew"}, {"slices", "32"}, {"exact_layers", "0"}});
    all.push_back({{"sampling", "linear"}, {"bias", "0"}, {"samples", "4"}});
    all.push_back({{"sampling", "cubic"}, {"bias", "0"}});
    all.push_back({{"sampling", "cubic"}, {"bias", "0.5"}});
    return all;
  }
  static std::string text(const Map& settings) {
    std::string all;
    for (const auto& [name, value] : settings) all += name + "=" + value + " ";
    return all;
  }
};

TEST_F(AvboitSparse, GivesTheSamePictureAsDenseToTheBit) {
  for (const bool with_rgb : {true, false}) {
    // Dense, every card counts as behind RGB sources, so that the draws come in another order: a few
    // roundings of the half floats they are summed in.
    const float bound = with_rgb ? 4.0f / 1024 : 0.0f;
    if (!with_rgb) rgb.clear();
    for (const char* id : {"avboit", "vboit"})
      for (Map chosen : variants()) {
        SCOPED_TRACE(id + (" " + text(chosen)));
        const auto sparse = draw_cards(id, chosen).linear.pixels;
        chosen["sparse"] = "false";
        const auto dense = draw_cards(id, chosen).linear.pixels;
        for (size_t i = 0; i < dense.size(); ++i)
          for (int c = 0; c < 3; ++c)
            ASSERT_NEAR(dense[i][c], sparse[i][c], bound * std::max(dense[i][c], 0.25f)) << "pixel " << i;
      }
  }
}

TEST_F(AvboitSparse, NothingIsReadThatTheFrameDidNotWrite) {
  for (const char* id : {"avboit", "vboit"})
    for (const Map& chosen : variants()) {
      SCOPED_TRACE(id + (" " + text(chosen)));
      const auto clean = draw_cards(id, chosen).linear.pixels,
                 poisoned = draw_cards(id, chosen, true).linear.pixels;
      for (size_t i = 0; i < clean.size(); ++i) ASSERT_EQ(clean[i], poisoned[i]) << "pixel " << i;
    }
}

TEST_F(AvboitSparse, ACardWhereASliceBeginsIsInASliceThatIsThere) {
  // Far from the world's origin a vertex's depth and the card's bounds round differently: one may be on
  // either side of the beginning of a slice.
  scene.solids.clear();
  for (int turn = 0; turn < 6; ++turn) {
    clear_cards();
    const glm::vec3 eye(random.f(-90, 90), random.f(1, 20), random.f(-90, 90));
    scene.camera[0].position = eye;
    scene.camera[0].target = eye + glm::vec3(random.f(-1, 1), random.f(-0.5, 0.5), random.f(-1, 1));
    const shared::ViewData v = view();
    for (int i = 0; i < 200; ++i) {
      const double slice = 10 + random.below(100), z = 2 * (std::exp2(slice * std::log2(401.0) / 128) - 1);
      shared::Card card = make_card({.optical_depth = 0.2f, .color = glm::vec3(0.5f)});
      card.center = eye + v.forward * float(z) + v.right * float(z * random.between(-0.5, 0.5));
      card.axis_u = v.right * float(z) * 0.1f;
      card.axis_v = v.up * float(z) * 0.1f;
      scalar.push_back(card);
    }
    for (const char* linear : {"true", "false"}) {
      const Map chosen{{"linear_splat", linear}, {"exact_layers", "0"}, {"splat", "words32"}};
      SCOPED_TRACE(text(chosen));
      const auto clean = draw_cards("vboit", chosen).linear.pixels,
                 poisoned = draw_cards("vboit", chosen, true).linear.pixels;
      Map all = chosen;
      all["sparse"] = "false";
      const auto dense = draw_cards("vboit", all).linear.pixels;
      for (size_t i = 0; i < clean.size(); ++i) {
        ASSERT_EQ(clean[i], poisoned[i]) << "pixel " << i;
        ASSERT_EQ(clean[i], dense[i]) << "pixel " << i;
      }
    }
  }
}

TEST_F(AvboitSparse, TheIntegralThatIsReadIsTheSame) {
  for (const bool rgb_packed : {false, true}) {
    avboit::Settings s;
    s.rgb_splat = rgb_packed ? avboit::RgbSplat::kPacked10 : avboit::RgbSplat::kWords32;
    const Stages sparse = run_stages(s, Until::kIntegrate);
    s.sparse = false;
    const Stages dense = run_stages(s, Until::kIntegrate);
    const Masks masks{sparse.words("occupancy"), sparse.volume()};
    ASSERT_EQ(masks.words, dense.words("occupancy"));
    ASSERT_EQ(sparse.words("zero_slice"), dense.words("zero_slice"));
    size_t compared = 0;
    for (uint32_t slice = 0; slice < sparse.warp().head.used; ++slice) {
      const auto a = read_layer<uint32_t>(sparse.resources.image("integral"), slice),
                 b = read_layer<uint32_t>(dense.resources.image("integral"), slice);
      const auto a_rg = read_layer<uint64_t>(sparse.resources.image("integral_rg"), slice),
                 b_rg = read_layer<uint64_t>(dense.resources.image("integral_rg"), slice);
      for (uint32_t ray = 0; ray < a.size(); ++ray) {
        const glm::uvec2 cell{ray % sparse.volume().cells.x, ray / sparse.volume().cells.x};
        if (!masks.has(false, cell, slice) && !masks.has(true, cell, slice)) continue;
        ++compared;
        ASSERT_EQ(b[ray], a[ray]);
        ASSERT_EQ(b_rg[ray], a_rg[ray]);
      }
    }
    EXPECT_GT(compared, 1000u);
  }
}

}  // namespace
}  // namespace plume
