// From depth to slice: the curve, which slices cards cover, and what adaptation makes of them.
#include <algorithm>
#include <numeric>
#include <set>

#include "shaders/shared/workload.h"
#include "tests/gpu/avboit_probe.h"

namespace plume {
namespace {

using namespace shared;

constexpr uint32_t kWords = kMostVirtualSlices / 32;

Volume volume_of(uint32_t slices, uint32_t virtual_slices, float a = 2.0f, float b = 800.0f) {
  Volume v{};
  v.slices = slices;
  v.virtual_slices = virtual_slices;
  v.curve_a = a;
  v.curve_octaves = std::log2(1.0f + b / a);
  v.guard_after = 1;
  return v;
}

// ---- the curve

using AvboitCurve = AvboitProbe;

TEST_F(AvboitCurve, IsTheLogarithmOfDepthClampedToTheVolume) {
  write_probe("curve_probe.comp", R"(
#include "methods/avboit/depth_curve.glsl"
layout(local_size_x = 64) in;
layout(scalar, binding = 0) uniform VolumeBlock { Volume volume; };
layout(scalar, binding = 1) readonly buffer Depths { float depths[]; };
layout(scalar, binding = 2) writeonly buffer Slices { vec2 found[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  const float scale = float(volume.virtual_slices) / volume.curve_octaves;
  const float slice = virtual_slice(volume, volume.virtual_slices, scale, depths[i]);
  found[i] = vec2(slice, depth_of_slice(volume, scale, slice));
})");
  Random random(1);
  double worst = 0, worst_back = 0;
  for (int round = 0; round < 12; ++round) {
    const float a = float(random.octaves(0.06, 64)), b = a * float(random.octaves(4, 16000));
    const Volume v = volume_of(128, 32u << (round % 11), a, b);
    std::vector<float> depths{0.0f, -1.0f, 1e-6f, a, b, std::nextafter(b, 0.0f), 1e9f, 3e38f};
    while (depths.size() < 512) depths.push_back(float(random.octaves(1e-3, 1e6)));
    const gpu::Buffer block = upload("volume", std::vector{v}), in = upload("depths", depths),
                      out = upload("slices", std::vector<glm::vec2>(512));
    ask("curve_probe.comp", {}, {{"VolumeBlock", &block}, {"Depths", &in}, {"Slices", &out}}, 0u, 8);
    const auto found = gpu::read<glm::vec2>(device, out);
    for (size_t i = 0; i < depths.size(); ++i) {
      const double expected = virtual_slice(v, v.virtual_slices, depths[i]);
      ASSERT_GE(found[i].x, 0.0f);
      ASSERT_LT(found[i].x, float(v.virtual_slices)) << "depth " << depths[i];
      worst = std::max(worst, std::abs(expected - double(found[i].x)) / v.virtual_slices);
      if (depths[i] >= 0.0f && expected < v.virtual_slices - 1.0)
        worst_back = std::max(worst_back, std::abs(double(found[i].y - depths[i])) / double(a + depths[i]));
    }
  }
  RecordProperty("worst_share_of_all_slices", std::to_string(worst));
  RecordProperty("worst_depth_over_a_plus_depth", std::to_string(worst_back));
  // 24 bits of mantissa, a logarithm with a few of them lost.
  EXPECT_LT(worst, 1e-6);
  EXPECT_LT(worst_back, 2e-5);
}

// ---- coverage

class AvboitCoverage : public AvboitTest {
 protected:
  struct Bits {
    std::vector<uint32_t> words;
    bool covered(uint32_t slice) const { return words[slice / 32] >> slice % 32 & 1; }
    bool apart(uint32_t slice) const { return words[kWords + slice / 32] >> slice % 32 & 1; }
  };
  Bits cover(const std::vector<Card>& cards, Volume v) {
    v.cards = uint32_t(cards.size());
    const gpu::Buffer block = upload("volume", std::vector{v}), eye = upload("view", std::vector{view()}),
                      in = upload("cards", cards),
                      out = upload("coverage", std::vector<uint32_t>(2 * kWords)),
                      work = upload("work", std::vector{shared::workload_of(v.cards)});
    std::vector<uint32_t> in_order(cards.size());
    std::iota(in_order.begin(), in_order.end(), 0u);
    const gpu::Buffer seen = upload("order", in_order);
    dispatch("methods/avboit/coverage.comp", {},
             {{"VolumeBlock", &block},
              {"View", &eye},
              {"Cards", &in},
              {"Order", &seen},
              {"Work", &work},
              {"Coverage", &out}},
             0u, {gpu::groups(cards.size(), 256), 1, 1});
    return {gpu::read<uint32_t>(device, out)};
  }
  /// Exactly the slices between the bounds; the first and the last may be off by one where a bound is within
  /// rounding of a boundary.
  static void expect_slices(const Bits& bits, const Volume& v, const CardBounds& b, bool apart) {
    constexpr double kRounding = 0.02;  // slices, of 32768
    if (!b.seen) {
      EXPECT_TRUE(std::ranges::all_of(bits.words, [](uint32_t w) { return w == 0; }));
      return;
    }
    const double first = virtual_slice(v, v.virtual_slices, b.nearest),
                 last = virtual_slice(v, v.virtual_slices, b.farthest);
    for (uint32_t s = 0; s < v.virtual_slices; ++s) {
      const bool surely = s > first - 1 + kRounding && s < last - kRounding;
      const bool maybe = s > first - 1 - kRounding && s < last + kRounding;
      const bool found = bits.covered(s);
      ASSERT_TRUE(found ? maybe : !surely) << "slice " << s << " of " << first << " to " << last;
      ASSERT_EQ(apart && found, bits.apart(s));
    }
  }
};

TEST_F(AvboitCoverage, IsTheSlicesBetweenACardsBounds) {
  Random random(2);
  const Volume fine = volume_of(128, 8192), coarse = volume_of(128, 1024, 6.5f, 60.0f);
  std::vector<PlacedCard> tried{
      {.z = 5, .half_size = {1, 1}},                                   // faces the camera: one slice
      {.z = 0.05f, .half_size = {1, 1}},                               // in front of the near plane
      {.z = 0.3f, .half_size = {1, 1}, .yaw = 1.5f},                   // crosses it
      {.z = -20, .half_size = {5, 5}},                                 // behind the camera
      {.z = -3, .half_size = {30, 1}, .yaw = 1.57f},                   // behind it, reaching in front
      {.z = 790, .half_size = {60, 1}, .yaw = 1.2f},                   // crosses the last slice
      {.z = 5000, .half_size = {1, 1}},                                // beyond it
      {.z = 5, .half_size = {1, 1}, .at = {1000, 0}},                  // off the screen
      {.z = 5, .half_size = {1, 1}, .at = {0, -1000}},                 //
      {.z = 60, .half_size = {59, 1}, .yaw = 1.5707f},                 // thousands of slices thick
      {.z = 60, .half_size = {59, 1}, .yaw = 1.5707f, .apart = true},  // and set apart
      {.z = 7, .optical_depth = 0, .half_size = {1, 1}},               // dead
      {.z = 7, .optical_depth = 0, .emission = {1, 0, 0}, .half_size = {1, 1}},  // it only shines
      {.z = 0.1f, .half_size = {1e-6f, 1e-6f}},                                  // on the near plane
  };
  for (int i = 0; i < 60; ++i)
    tried.push_back({.z = float(random.octaves(0.01, 250)),
                     .half_size = {random.octaves(0.03, 32), random.octaves(0.03, 32)},
                     .at = {random.f(-20, 20), random.f(-20, 20)},
                     .yaw = random.f(-3, 3),
                     .pitch = random.f(-1.5, 1.5),
                     .apart = i % 5 == 0});
  size_t seen = 0;
  for (const Volume& v : {fine, coarse})
    for (const PlacedCard& c : tried) {
      const Card card = make_card(c);
      const CardBounds b = bounds_of(card, view());
      seen += b.seen;
      SCOPED_TRACE(testing::Message() << "z " << c.z << " yaw " << c.yaw << " pitch " << c.pitch << " size "
                                      << c.half_size.x << " x " << c.half_size.y);
      expect_slices(cover({card}, v), v, b, c.apart);
    }
  EXPECT_GT(seen, 40u) << "too few cards are on the screen to prove anything";
}

TEST_F(AvboitCoverage, OfManyCardsIsTheUnion) {
  Random random(3);
  const Volume v = volume_of(128, 4096);
  std::vector<Card> many;
  std::vector<uint32_t> united(2 * kWords);
  for (int i = 0; i < 40; ++i) {
    many.push_back(make_card({.z = float(random.octaves(2, 100)),
                              .half_size = {2, 1},
                              .yaw = random.f(-2, 2),
                              .apart = i % 7 == 0}));
    const Bits alone = cover({many.back()}, v);
    for (size_t w = 0; w < united.size(); ++w) united[w] |= alone.words[w];
  }
  while (many.size() < 700) many.push_back(many[random.below(40)]);  // three work groups
  EXPECT_EQ(united, cover(many, v).words);
}

// ---- adaptation

class AvboitAdapt : public AvboitTest {
 protected:
  using Flags = std::vector<bool>;

  Warp adapt(const Volume& v, const std::vector<uint32_t>& coverage) {
    const gpu::Buffer block = upload("volume", std::vector{v}), in = upload("coverage", coverage),
                      out = upload("warp", std::vector<uint32_t>(sizeof(DepthWarp) / 4 + kMostSlices +
                                                                 kMostVirtualSlices + 1));
    dispatch("methods/avboit/adapt.comp", {},
             {{"VolumeBlock", &block}, {"Coverage", &in}, {"WarpTable", &out}}, 0u, {1, 1, 1});
    return Warp::from(gpu::read<uint32_t>(device, out));
  }

  static Flags merged(const Flags& fine) {
    Flags coarse(fine.size() / 2);
    for (size_t i = 0; i < coarse.size(); ++i) coarse[i] = fine[2 * i] || fine[2 * i + 1];
    return coarse;
  }
  static Flags with_guards(const Flags& covered, const Volume& v) {
    Flags all(covered.size());
    for (int64_t i = 0; i < int64_t(covered.size()); ++i)
      if (covered[size_t(i)])
        for (int64_t k = std::max<int64_t>(i - v.guard_before, 0);
             k <= std::min<int64_t>(i + v.guard_after, int64_t(covered.size()) - 1); ++k)
          all[size_t(k)] = true;
    return all;
  }
  /// Physical slices of each virtual one.
  static std::vector<uint32_t> widths(const Flags& covered, const Flags& apart, const Volume& v,
                                      uint32_t apart_width) {
    const Flags all = with_guards(covered, v);
    std::vector<uint32_t> w(all.size());
    for (size_t i = 0; i < all.size(); ++i) w[i] = !all[i] ? 0 : apart[i] ? apart_width : 1;
    return w;
  }

  /// Everything that adaptation promises, from the coverage alone.
  static void expect_adapted(const Volume& v, const std::vector<uint32_t>& words, const Warp& warp) {
    Flags covered(v.virtual_slices), apart(v.virtual_slices);
    for (size_t i = 0; i < covered.size(); ++i) {
      covered[i] = words[i / 32] >> i % 32 & 1;
      apart[i] = words[kWords + i / 32] >> i % 32 & 1;
    }
    const auto used_at = [&](uint32_t apart_width) {
      const auto w = widths(covered, apart, v, apart_width);
      return std::accumulate(w.begin(), w.end(), 0u);
    };
    while (covered.size() > kLeastVirtualSlices && used_at(kApartWidth) > v.slices) {
      ASSERT_NE(warp.head.virtual_slices, covered.size()) << "stopped where it does not fit";
      covered = merged(covered), apart = merged(apart);
    }
    const bool dropped = used_at(kApartWidth) > v.slices;
    ASSERT_EQ(covered.size(), warp.head.virtual_slices) << "halved more or less often than needed";
    ASSERT_EQ(dropped ? 1u : 0u, warp.head.apart_dropped);
    const auto width = widths(covered, apart, v, dropped ? 1 : kApartWidth);
    ASSERT_LE(warp.head.used, v.slices);
    EXPECT_FLOAT_EQ(float(warp.head.virtual_slices) / v.curve_octaves, warp.head.scale);
    uint32_t before = 0;
    for (uint32_t i = 0; i < covered.size(); ++i) {
      ASSERT_EQ(float(before), warp.nodes[i]) << "virtual slice " << i;
      for (uint32_t k = 0; k < width[i]; ++k) {
        const double slice = i + double(k + 1) / width[i];
        const double end =
            double(v.curve_a) * (std::exp2(slice * double(v.curve_octaves) / double(covered.size())) - 1);
        ASSERT_NEAR(end, double(warp.slice_ends[before + k]), 2e-6 * (end + double(v.curve_a)));
      }
      before += width[i];
    }
    ASSERT_EQ(before, warp.head.used);
    ASSERT_EQ(float(before), warp.nodes.back());
  }

  /// Slopes: 1 (or kApartWidth) inside what is occupied, 0 in gaps; ends ascend; guards stand.
  static void expect_properties(const Volume& v, const std::vector<uint32_t>& words, const Warp& warp) {
    const uint32_t shrink = v.virtual_slices / warp.head.virtual_slices;
    const auto slope = [&](uint32_t i) { return warp.nodes[i + 1] - warp.nodes[i]; };
    for (uint32_t i = 0; i < warp.head.virtual_slices; ++i)
      ASSERT_TRUE(slope(i) == 0 || slope(i) == 1 || (slope(i) == kApartWidth && !warp.head.apart_dropped));
    for (uint32_t fine = 0; fine < v.virtual_slices; ++fine) {
      if (!(words[fine / 32] >> fine % 32 & 1)) continue;
      const uint32_t i = fine / shrink;
      for (uint32_t k = i - std::min(i, v.guard_before);
           k <= std::min(i + v.guard_after, warp.head.virtual_slices - 1); ++k)
        ASSERT_GE(slope(k), 1.0f) << "no guard at " << k << " around " << i;
    }
    ASSERT_TRUE(std::ranges::is_sorted(warp.nodes));
    ASSERT_TRUE(std::ranges::is_sorted(warp.slice_ends));
  }

  static void set(std::vector<uint32_t>& words, uint32_t slice, bool apart = false) {
    words[slice / 32] |= 1u << slice % 32;
    if (apart) words[kWords + slice / 32] |= 1u << slice % 32;
  }
};

TEST_F(AvboitAdapt, EqualsAModelForEveryBudgetAndRandomCoverage) {
  Random random(4);
  std::set<uint32_t> resolutions;
  size_t dropped = 0;
  for (uint32_t budget = 32; budget <= 256; ++budget) {
    Volume v = volume_of(budget, 1024u << random.below(6));
    v.guard_before = random.one_in(4) ? 9 : random.below(4);
    v.guard_after = 1 + random.below(2);
    std::vector<uint32_t> words(2 * kWords);
    const uint32_t runs = 1 + random.below(random.one_in(3) ? 200 : 6);
    const uint32_t longest = 1 + random.below(std::max(v.virtual_slices >> random.below(12), 1u));
    for (uint32_t r = 0; r < runs; ++r) {
      const uint32_t first = random.below(v.virtual_slices), length = 1 + random.below(longest);
      const bool apart = random.one_in(5);
      for (uint32_t s = first; s < std::min(first + length, v.virtual_slices); ++s) set(words, s, apart);
    }
    const Warp warp = adapt(v, words);
    SCOPED_TRACE(testing::Message() << "budget " << budget << " of " << v.virtual_slices << " guards "
                                    << v.guard_before << " " << v.guard_after);
    expect_adapted(v, words, warp);
    expect_properties(v, words, warp);
    resolutions.insert(warp.head.virtual_slices);
    dropped += warp.head.apart_dropped;
    if (HasFatalFailure()) return;
  }
  EXPECT_GT(resolutions.size(), 6u) << "too few kinds of coverage to prove anything";
  EXPECT_GT(dropped, 0u);
}

TEST_F(AvboitAdapt, EqualsAModelForAwkwardCoverage) {
  const auto check = [&](const Volume& v, const std::vector<uint32_t>& words) {
    const Warp warp = adapt(v, words);
    expect_adapted(v, words, warp);
    expect_properties(v, words, warp);
    return warp;
  };
  for (const uint32_t budget : {32u, 128u, 256u}) {
    const Volume v = volume_of(budget, kMostVirtualSlices);
    std::vector<uint32_t> none(2 * kWords), all(2 * kWords, ~0u), ends = none, stripes = none, covered = all;
    for (uint32_t w = 0; w < kWords; ++w) stripes[w] = 0x55555555u, covered[kWords + w] = 0;
    set(ends, 0), set(ends, v.virtual_slices - 1);
    EXPECT_EQ(0u, check(v, none).head.used);
    EXPECT_EQ(4u - 1, check(v, ends).head.used);
    EXPECT_EQ(v.virtual_slices, check(v, ends).head.virtual_slices) << "the finest that fits";
    check(v, all);
    EXPECT_EQ(budget, check(v, covered).head.used) << "everything occupied fills the budget";
    check(v, stripes);
    for (const uint32_t slice : {31u, 32u, 63u, 64u, 8191u}) {  // guards reach into the next word
      std::vector<uint32_t> one = none;
      set(one, slice, slice % 2 == 0);
      check(v, one);
    }
  }
}

TEST_F(AvboitAdapt, FixedSlicesAreAllOfThemWhateverIsCovered) {
  for (const uint32_t slices : {32u, 64u, 128u, 256u}) {
    Volume v = volume_of(slices, 8192);
    v.fixed_slices = 1;
    const Warp warp = adapt(v, std::vector<uint32_t>(2 * kWords));
    EXPECT_EQ(slices, warp.head.used);
    EXPECT_EQ(slices, warp.head.virtual_slices);
    for (uint32_t i = 0; i <= slices; ++i) EXPECT_EQ(float(i), warp.nodes[i]);
  }
}

TEST_F(AvboitAdapt, TheFrameAdaptsToTheCoverageOfItsCards) {
  Random random(5);
  for (int i = 0; i < 50; ++i)
    add({.z = float(random.octaves(3, 35)),
         .half_size = {1, 1},
         .yaw = random.f(-1, 1),
         .apart = i % 9 == 0});
  avboit::Settings settings;
  settings.sampling = avboit::Sampling::kCubic;
  settings.bias = 2.5f;
  const Stages s = run_stages(settings, Until::kAdapt);
  EXPECT_EQ(4u, s.volume().guard_before);
  expect_adapted(s.volume(), s.words("coverage"), s.warp());
  expect_properties(s.volume(), s.words("coverage"), s.warp());
}

}  // namespace
}  // namespace plume
