// The splat: optical depth as packed integers, word for word.
#include <algorithm>

#include "shaders/methods/avboit/card_class.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

using avboit::RgbSplat;
using avboit::Splat;

class AvboitSplat : public AvboitTest {
 protected:
  AvboitSplat() {
    settings.adaptive = false;  // fixed slices: their places are known before the cards are
    settings.exact_layers = 0;
    settings.curve_a = 4.0f;
    settings.curve_b = 100.0f;
  }
  avboit::Settings settings;
  Random random{1};

  double position_of(double z) const {
    const double n = settings.slice_count();
    return n * std::log2(1 + z / double(settings.curve_a)) /
           std::log2(1 + double(settings.curve_b) / double(settings.curve_a));
  }
  double depth_of(double position) const {
    return double(settings.curve_a) * (std::pow(1 + double(settings.curve_b) / double(settings.curve_a),
                                                position / settings.slice_count()) -
                                       1);
  }
  static double steps(uint32_t bits) {
    return bits == 8 ? 255 / std::log(255.0) : bits == 16 ? 65535 / 16.0 : 4096;
  }

  struct Share {
    uint32_t slice;
    double here, beyond;  ///< in steps, before they are rounded
  };
  Share share_of(double z, double tau, uint32_t bits) const {
    tau = std::min(tau, bits == 8 ? std::log(255.0) : 16.0);
    const double position = position_of(z);
    const uint32_t slice = uint32_t(position);
    const double part = settings.linear_splat ? position - slice : 0;
    return {slice, tau * (1 - part) * steps(bits), tau * part * steps(bits)};
  }
  /// The GPU's logarithms must not decide what the nearest integer is.
  static bool rounds_surely(double value) { return std::abs(value - std::floor(value) - 0.5) > 0.1; }
  static uint64_t rounded(double value) { return uint64_t(value + 0.5); }

  struct Layer {
    double z;
    glm::dvec3 tau;
  };
  /// At a depth between `from` and `to` slices, so that every share rounds surely.
  Layer layer(double from, double to, double least_tau, double most_tau, uint32_t bits,
              bool rgb_source = false) {
    for (;;) {
      const float z = float(depth_of(random.between(from, to)));
      if (rgb_source) {
        // Coverage 1 and a transmission of each channel that a half float holds.
        glm::dvec3 tau(0.0);
        bool sure = true;
        for (int c = 0; c < 3; ++c) {
          const double through = double(
              glm::unpackHalf1x16(glm::packHalf1x16(float(std::exp(-random.between(least_tau, most_tau))))));
          tau[c] = -std::log(through);
          const Share s = share_of(z, tau[c], bits);
          sure = sure && rounds_surely(s.here) && rounds_surely(s.beyond);
        }
        if (sure) return {z, tau};
        continue;
      }
      const float tau = float(random.octaves(least_tau, most_tau));
      const Share s = share_of(z, tau, bits);
      if (rounds_surely(s.here) && rounds_surely(s.beyond)) return {z, glm::dvec3(tau)};
    }
  }
  void add_scalar(const Layer& l) { add({.z = float(l.z), .optical_depth = float(l.tau.x)}); }
  void add_rgb(const Layer& l) {
    add({.z = float(l.z), .optical_depth = shared::kOpaqueDepth, .transmission = glm::exp(-l.tau)});
  }
  /// Sums of a ray, a slice each, before packing.
  std::vector<uint64_t> sums_of(const std::vector<Layer>& layers, uint32_t bits, int channel = 0) const {
    std::vector<uint64_t> sums(settings.slice_count() + 1);
    for (const Layer& l : layers) {
      const Share s = share_of(l.z, l.tau[channel], bits);
      sums[s.slice] += rounded(s.here);
      sums[s.slice + 1] += rounded(s.beyond);
    }
    return sums;
  }
  void shuffle() {
    order.resize(scalar.size() + rgb.size());
    std::iota(order.begin(), order.end(), 0u);
    random.shuffle(order);
  }
  /// What the words of a ray hold: carries go where they go.
  std::vector<uint32_t> packed(const std::vector<uint64_t>& sums, uint32_t bits, bool saturate) const {
    const uint32_t lanes = 32 / bits;
    const uint64_t full = (uint64_t(1) << bits) - 1;
    std::vector<uint32_t> words(settings.slice_count() / lanes);
    for (uint32_t s = 0; s < settings.slice_count(); ++s)
      words[s / lanes] += uint32_t((saturate ? std::min(sums[s], full) : sums[s]) << bits * (s % lanes));
    return words;
  }
  /// Words of every ray that lie in slices that the occupancy promises; the rest is never read.
  void expect_words(const Stages& s, const std::vector<uint32_t>& expected) {
    const auto words = s.words("extinction"), occupancy = s.words("occupancy");
    const uint32_t per_ray = uint32_t(expected.size()), lanes = s.lanes();
    ASSERT_EQ(s.plan.rays() * per_ray, words.size());
    size_t compared = 0;
    for (uint64_t ray = 0; ray < s.plan.rays(); ++ray) {
      const glm::uvec2 tile =
          glm::uvec2(ray % s.volume().cells.x, ray / s.volume().cells.x) / shared::kTileCells;
      const uint32_t mask_at = (tile.y * s.volume().tiles.x + tile.x) * shared::kMaskWords;
      for (uint32_t w = 0; w < per_ray; ++w) {
        const uint32_t first = w * lanes, mask = lanes == 4 ? 15u : lanes == 2 ? 3u : 1u;
        if (!(occupancy[mask_at + first / 32] >> first % 32 & mask)) {
          ASSERT_EQ(0u, expected[w]) << "extinction outside what is occupied, word " << w;
          continue;
        }
        ++compared;
        ASSERT_EQ(expected[w], words[ray * per_ray + w]) << "ray " << ray << " word " << w;
      }
    }
    EXPECT_GE(compared, s.plan.rays());
  }
};

constexpr uint32_t bits_of(Splat splat) {
  return splat == Splat::kWords32 ? 32 : splat == Splat::kPacked16Overflow ? 16 : 8;
}
constexpr Splat kSplats[] = {Splat::kPacked8, Splat::kPacked8Exchange, Splat::kPacked8Overflow,
                             Splat::kPacked16Overflow, Splat::kWords32};

TEST_F(AvboitSplat, WordsAreTheSumsOfRoundedSharesWhateverTheOrder) {
  for (const Splat splat : kSplats)
    for (const bool linear : {false, true}) {
      SCOPED_TRACE(testing::Message() << "splat " << int(splat) << (linear ? " linear" : " point"));
      settings.splat = splat;
      settings.linear_splat = linear;
      clear_cards();
      std::vector<Layer> layers;
      const uint32_t bits = bits_of(splat);
      // Small enough that no field overflows; many more than lanes, also on both sides of a word's end.
      for (int i = 0; i < 60; ++i) layers.push_back(layer(2, 125, 0.01, 0.3, bits));
      for (const double edge : {3.0, 31.0, 63.0, 99.0})
        layers.push_back(layer(edge + 0.3, edge + 0.7, 0.1, 0.3, bits));
      for (const Layer& l : layers) add_scalar(l);
      shuffle();
      const auto sums = sums_of(layers, bits);
      ASSERT_LE(*std::ranges::max_element(sums), 255u * (bits == 8 ? 1u : 256u));
      const Stages s = run_stages(settings, Until::kSplat);
      expect_words(s, packed(sums, bits, false));
      for (const uint32_t first : s.words("overflow")) ASSERT_EQ(shared::kNoOverflow, first);
      if (HasFatalFailure()) return;
    }
}

TEST_F(AvboitSplat, AnOverflowCarriesIsSaturatedOrIsKnownByItsFirstSlice) {
  for (const Splat splat : kSplats) {
    if (splat == Splat::kWords32) continue;
    for (const bool linear : {false, true}) {
      SCOPED_TRACE(testing::Message() << "splat " << int(splat) << (linear ? " linear" : " point"));
      settings.splat = splat;
      settings.linear_splat = linear;
      clear_cards();
      const uint32_t bits = bits_of(splat);
      std::vector<Layer> layers;
      for (int i = 0; i < 10; ++i) layers.push_back(layer(2, 40, 0.02, 0.2, bits));  // in front: no overflow
      const double thick = bits == 8 ? 2 : 3;  // single precision knows 1 - e^-3 to a thousandth of a step
      const int many = bits == 8 ? 12 : 36;
      for (int i = 0; i < many; ++i) layers.push_back(layer(50.2, 53.8, thick / 2, thick, bits));
      for (int i = 0; i < many; ++i) layers.push_back(layer(80.2, 82.8, thick / 2, thick, bits));
      for (int i = 0; i < 10; ++i) layers.push_back(layer(50, 110, 0.02, 0.2, bits));
      for (const Layer& l : layers) add_scalar(l);
      shuffle();
      const auto sums = sums_of(layers, bits);
      const uint64_t full = (uint64_t(1) << bits) - 1;
      const auto over = [&](uint64_t sum) { return sum > full; };
      const uint32_t first = uint32_t(std::ranges::find_if(sums, over) - sums.begin());
      ASSERT_GE(std::ranges::count_if(sums, over), 2);
      const Stages s = run_stages(settings, Until::kSplat);
      expect_words(s, packed(sums, bits, splat == Splat::kPacked8Exchange));
      const bool known = splat == Splat::kPacked8Overflow || splat == Splat::kPacked16Overflow;
      for (const uint32_t found : s.words("overflow")) ASSERT_EQ(known ? first : shared::kNoOverflow, found);
      if (HasFatalFailure()) return;
    }
  }
}

TEST_F(AvboitSplat, AFieldIsExactlyFullBeforeItOverflows) {
  settings.splat = Splat::kPacked8Overflow;
  settings.linear_splat = false;
  // 255 events of one step each fill a field to the brim; the 256th overflows it.
  for (const uint32_t events : {255u, 256u}) {
    clear_cards();
    for (uint32_t i = 0; i < events; ++i)
      add({.z = float(depth_of(20.5)), .optical_depth = float(1.1 / steps(8))});
    const Stages s = run_stages(settings, Until::kSplat);
    for (const uint32_t found : s.words("overflow"))
      ASSERT_EQ(events == 256 ? 20u : shared::kNoOverflow, found) << events;
    std::vector<uint32_t> expected(settings.slice_count() / 4);
    expected[20 / 4] = events;  // slice 20 is the lowest lane: the carry is in the next one
    expect_words(s, expected);
  }
}

TEST_F(AvboitSplat, TheSharesOfAWarpedSliceAreThoseOfItsTable) {
  settings.adaptive = true;
  settings.splat = Splat::kWords32;
  for (int i = 0; i < 30; ++i)
    add({.z = float(random.octaves(4, 60)),
         .optical_depth = float(random.between(0.05, 0.4)),
         .apart = i % 7 == 0});
  const Stages s = run_stages(settings, Until::kSplat);
  const Warp warp = s.warp();
  std::vector<double> sums(s.volume().slices + 1);
  for (const shared::Card& card : scalar) {
    const double position = slice_at(s.volume(), warp, -double(card.center.z)),
                 part = position - std::floor(position);
    sums[size_t(position)] += double(card.optical_depth) * (1 - part) * 4096;
    sums[size_t(position) + 1] += double(card.optical_depth) * part * 4096;
  }
  const auto words = s.words("extinction");
  for (uint64_t ray = 0; ray < s.plan.rays(); ++ray)
    for (uint32_t slice = 0; slice < warp.head.used; ++slice)
      if (sums[slice] >
          0) {  // 2e-3 of a slice of 32768 is a logarithm's rounding, half a step a card that of the sum
        ASSERT_NEAR(sums[slice], words[ray * s.volume().slices + slice], 0.4 * 4096 * 4e-3 + 3)
            << "slice " << slice;
      }
}

TEST_F(AvboitSplat, DitherIsUnbiasedWhereRoundingLosesThinSmoke) {
  settings.splat = Splat::kPacked8;
  settings.linear_splat = false;
  constexpr uint32_t kCards = 96;
  for (const double share : {0.02, 0.3, 0.45, 1.7}) {
    clear_cards();
    for (uint32_t i = 0; i < kCards; ++i)
      add({.z = float(depth_of(4 * (i % 24) + 16.5)), .optical_depth = float(share / steps(8))});
    const auto mean = [&](bool dither) {
      settings.dither = dither;
      const Stages s = run_stages(settings, Until::kSplat);
      const auto words = s.words("extinction");
      double sum = 0;
      for (uint64_t ray = 0; ray < s.plan.rays(); ++ray)
        for (uint32_t k = 0; k < 24; ++k)  // slices 16, 20, 24, ...: the lowest lane of a word
          sum += words[ray * settings.slice_count() / 4 + 4 + k] & 255;
      return sum / double(s.plan.rays() * kCards);
    };
    const double part = share - std::floor(share), n = 40.0 * kCards;
    const double sigma = std::sqrt(part * (1 - part) / n);
    EXPECT_NEAR(share, mean(true), 4 * sigma) << "sigma is " << sigma;
    EXPECT_EQ(std::floor(share + 0.5), mean(false));
  }
}

TEST_F(AvboitSplat, ACellAtTheEdgeOfAPictureThatCellsDoNotDivideIsSplatted) {
  for (const glm::uvec2 odd : {glm::uvec2(17, 9), glm::uvec2(1, 1), glm::uvec2(63, 33)}) {
    size = odd;
    clear_cards();
    settings.splat = Splat::kWords32;
    settings.linear_splat = false;
    add({.z = float(depth_of(30.5)), .optical_depth = 0.5f});
    const Stages s = run_stages(settings, Until::kSplat);
    ASSERT_EQ((odd + 7u) / 8u, s.volume().cells);
    for (uint64_t ray = 0; ray < s.plan.rays(); ++ray)
      EXPECT_EQ(2048u, s.words("extinction")[ray * settings.slice_count() + 30]) << "ray " << ray;
  }
}

TEST_F(AvboitSplat, FourSamplesWeighACellByHowMuchOfItACardCovers) {
  size = {120, 80};
  settings.splat = Splat::kWords32;
  settings.linear_splat = false;
  const double z = depth_of(30.5);
  std::vector<size_t> cells(5);
  for (int i = 0; i < 8; ++i) {
    clear_cards();
    add({.z = float(z),
         .optical_depth = 0.5f,
         .half_size = {random.f(0.4, 2), random.f(0.4, 1)},
         .at = {random.f(-1, 1), random.f(-1, 1)}});
    for (settings.samples = 0; settings.samples < 2; ++settings.samples) {
      const Stages s = run_stages(settings, Until::kSplat);
      const auto words = s.words("extinction");
      for (uint32_t ray = 0; ray < s.plan.rays(); ++ray) {
        const glm::dvec2 middle = (glm::dvec2(ray % 15, ray / 15) + 0.5) * 8.0;
        if (!hit(scalar[0], middle, -1e-3)) continue;
        if (!hit(scalar[0], middle, 1e-3)) continue;
        int inside = 0;
        bool sure = true;
        for (int k = 0; k < 4; ++k) {
          const glm::dvec2 at = middle + glm::dvec2(k & 1 ? 2 : -2, k & 2 ? 2 : -2);
          inside += hit(scalar[0], at).has_value();
          sure = sure && hit(scalar[0], at, 1e-3).has_value() == hit(scalar[0], at, -1e-3).has_value();
        }
        if (!sure) continue;
        ++cells[size_t(inside)];
        ASSERT_EQ(settings.samples == 0 ? 2048u : 512u * uint32_t(inside), words[ray * 128 + 30])
            << "ray " << ray;
      }
    }
  }
  EXPECT_GT(cells[4], 10u);
  EXPECT_GT(cells[1] + cells[2], 10u) << "cells that a card covers in part";
}

TEST_F(AvboitSplat, WhatIsBehindTheFarthestSurfaceOfACellIsNotSplatted) {
  size = {64, 64};
  Solid wall;  // covers the right half of the picture, from within a cell on: its front is 5.5 m away
  wall.position = {10 - 0.3f, 0, -6};
  wall.size_m = {20, 40, 1};
  scene.solids = {wall};
  settings.splat = Splat::kWords32;
  settings.linear_splat = false;
  add({.z = float(depth_of(20.5)), .optical_depth = 0.25f});   // in front of the wall: 3.0 m
  add({.z = float(depth_of(100.5)), .optical_depth = 0.25f});  // behind it
  ASSERT_LT(depth_of(20.5), 5.0);
  ASSERT_GT(depth_of(100.5), 8.0);
  const Stages s = run_stages(settings, Until::kSplat);
  const auto words = s.words("extinction");
  for (uint32_t y = 0; y < 8; ++y)
    for (uint32_t x = 0; x < 8; ++x) {
      const uint64_t ray = y * 8 + x;
      EXPECT_EQ(1024u, words[ray * 128 + 20]) << x << " " << y;
      // The cell of the edge sees past it.
      EXPECT_EQ(x < 4 ? 1024u : 0u, words[ray * 128 + 100]) << x << " " << y;
    }
}

// ---- RGB sources

TEST_F(AvboitSplat, RgbWordsAreTheSumsOfEachChannel) {
  for (const RgbSplat kind : {RgbSplat::kPacked10, RgbSplat::kWords32})
    for (const bool linear : {false, true}) {
      SCOPED_TRACE(testing::Message() << "rgb_splat " << int(kind) << (linear ? " linear" : " point"));
      settings.rgb_splat = kind;
      settings.linear_splat = linear;
      clear_cards();
      const uint32_t bits = kind == RgbSplat::kPacked10 ? 8 : 32;
      std::vector<Layer> layers;
      for (int i = 0; i < 24; ++i) layers.push_back(layer(2, 120, 0.05, 0.4, bits, true));
      for (int i = 0; i < 4; ++i) layers.push_back(layer(60.2, 61.8, 1.0, 2.5, bits, true));
      for (const Layer& l : layers) add_rgb(l);
      shuffle();
      ASSERT_EQ(28u, rgb.size());
      const Stages s = run_stages(settings, Until::kSplat);
      const auto words = s.words("extinction_rgb"), first = s.words("overflow_rgb"),
                 occupancy = s.words("occupancy");
      const uint64_t rays = s.plan.rays(), tiles = s.plan.tiles();
      ASSERT_EQ(1u, tiles);
      std::vector<uint64_t> sums[3];
      uint32_t overflows[3];
      for (int c = 0; c < 3; ++c) {
        sums[c] = sums_of(layers, bits, c);
        overflows[c] =
            uint32_t(std::ranges::find_if(sums[c], [](uint64_t v) { return v > 255; }) - sums[c].begin());
        ASSERT_LE(*std::ranges::max_element(sums[c]), kind == RgbSplat::kPacked10 ? 1023u : ~0u);
      }
      for (uint64_t ray = 0; ray < rays; ++ray) {
        for (uint32_t slice = 0; slice < settings.slice_count(); ++slice) {
          if (!(occupancy[shared::kMaskWords + slice / 32] >> slice % 32 & 1)) {
            ASSERT_EQ(0u, sums[0][slice] + sums[1][slice] + sums[2][slice]) << "not occupied: " << slice;
            continue;
          }
          const uint64_t at = ray * settings.slice_count() + slice;
          if (kind == RgbSplat::kPacked10)
            ASSERT_EQ(sums[0][slice] | sums[1][slice] << 10 | sums[2][slice] << 20, words[at])
                << "slice " << slice;
          else
            for (int c = 0; c < 3; ++c)
              ASSERT_EQ(sums[c][slice], words[at * 3 + uint32_t(c)]) << "slice " << slice;
        }
        if (kind == RgbSplat::kWords32) continue;
        for (uint32_t c = 0; c < 3; ++c)
          ASSERT_EQ(overflows[c] > settings.slice_count() ? shared::kNoOverflow : overflows[c],
                    first[ray * 3 + c]);
        ASSERT_EQ(shared::kNoOverflow, first[rays * 3 + ray]) << "no field was left";
      }
      if (HasFatalFailure()) return;
    }
}

TEST_F(AvboitSplat, FourSaturatedRedEventsStayInTheirFieldAndAFifthIsSeenToCarry) {
  settings.rgb_splat = RgbSplat::kPacked10;
  settings.linear_splat = false;
  struct Events {
    uint32_t saturated, single;  // of 255 steps, of one
  };
  for (const auto& [saturated, single] : {Events{1, 0}, {1, 1}, {0, 255}, {4, 3}, {4, 4}, {5, 0}, {9, 0}}) {
    clear_cards();
    const uint32_t sum = 255 * saturated + single;
    SCOPED_TRACE(sum);
    for (uint32_t i = 0; i < saturated + single; ++i)
      add({.z = float(depth_of(40.5)),
           .optical_depth = i < saturated ? shared::kOpaqueDepth : float(1.1 / steps(8)),
           .transmission = {0, 1, 1}});
    const Stages s = run_stages(settings, Until::kSplat);
    const auto words = s.words("extinction_rgb"), first = s.words("overflow_rgb");
    const uint64_t rays = s.plan.rays();
    for (uint64_t ray = 0; ray < rays; ++ray) {
      ASSERT_EQ(sum, words[ray * settings.slice_count() + 40]);
      ASSERT_EQ(sum > 255 ? 40u : shared::kNoOverflow, first[ray * 3]);
      ASSERT_EQ(shared::kNoOverflow, first[ray * 3 + 1]);
      ASSERT_EQ(shared::kNoOverflow, first[ray * 3 + 2]);
      ASSERT_EQ(sum > 1023 ? 40u : shared::kNoOverflow, first[rays * 3 + ray]);
    }
  }
}

TEST_F(AvboitSplat, AHundredSaturatedRedEventsLeaveGreenAndBlueAtZeroInWords) {
  settings.linear_splat = false;
  for (uint32_t i = 0; i < 100; ++i)
    add({.z = float(depth_of(40.5)), .optical_depth = shared::kOpaqueDepth, .transmission = {0, 1, 1}});
  const Stages s = run_stages(settings, Until::kSplat);
  const auto words = s.words("extinction_rgb");
  for (uint64_t ray = 0; ray < s.plan.rays(); ++ray) {
    const uint64_t at = (ray * settings.slice_count() + 40) * 3;
    ASSERT_EQ(100u * 65536u, words[at]);  // e^-16 an event
    ASSERT_EQ(0u, words[at + 1]);
    ASSERT_EQ(0u, words[at + 2]);
  }
}

TEST_F(AvboitSplat, EveryVisibleCardGoesIntoExactlyOneOfScalarRgbAndLayers) {
  settings.exact_layers = 2;
  for (int i = 0; i < 80; ++i)
    add({.z = random.f(-3, 30),
         .optical_depth = i % 6 == 5 ? 0.0f : random.f(0.02, 2),
         .transmission = i % 3 == 0 ? glm::vec3(0.9f, 0.2f, 0.4f) : glm::vec3(0.0f),
         .emission = glm::vec3(0.2f),
         .half_size = glm::vec2(random.f(0.05, 2)),
         .at = {random.f(-4, 4), random.f(-2, 2)},
         .yaw = random.f(-2, 2),
         .layer = i % 4 == 0   ? shared::kSolidLayer
                  : i % 4 == 1 ? shared::kSoftLayer
                               : 0});
  shuffle();
  const Stages s = run_stages(settings, Until::kSplat);
  const auto sorted = s.words("source_order"), draws = s.words("source_draws");
  const auto all = cards();
  std::vector<uint32_t> expected[3], found[3];
  std::vector<uint32_t> submitted = order;
  std::ranges::stable_partition(submitted, [&](uint32_t id) { return id < scalar.size(); });
  for (const uint32_t id : submitted) {
    const shared::Card& card = all[id];
    if (card.optical_depth <= 0 || !bounds_of(card, view()).seen) continue;
    const double pixels =
        0.5 * size.y / (double(view().tan_half_fov.y) * std::max(-double(card.center.z), 0.1));
    const double smaller =
        std::min(double(glm::length(card.axis_u)), double(glm::length(card.axis_v))) * pixels;
    const double small = card.optical_depth >= 0.3f ? 24 : 2;  // of a few cells and seen, or between samples
    const bool sharp =
        card.optical_depth >= 0.05f && ((card.layers & 0xfff) == shared::kSolidLayer || smaller < small);
    expected[sharp                 ? shared::kIntoLayers
             : id >= scalar.size() ? shared::kIntoRgb
                                   : shared::kIntoScalar]
        .push_back(id);
  }
  for (uint32_t into = 0; into < 3; ++into) {
    for (uint32_t i = 0; i < draws[into * 4 + 1]; ++i) found[into].push_back(sorted[draws[into * 4 + 3] + i]);
    EXPECT_GT(expected[into].size(), 2u);
    EXPECT_EQ(expected[into], found[into]) << "by source, in the order of submission, into " << into;
  }
}

}  // namespace
}  // namespace plume
