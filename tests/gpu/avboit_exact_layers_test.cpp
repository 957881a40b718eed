// The exact layers of a pixel: its nearest sharp fragments, whatever the order they came in.
#include <algorithm>
#include <bit>

#include "shaders/methods/avboit/exact_layers.h"
#include "tests/gpu/avboit_scene.h"

namespace plume {
namespace {

class AvboitExactLayers : public AvboitTest {
 protected:
  AvboitExactLayers() { size = {40, 24}; }
  avboit::Settings settings;
  Random random{1};

  struct Fragment {
    double depth;
    glm::dvec3 through;
    uint32_t card;
  };
  static Fragment fragment_of(const shared::Card& card, uint32_t index, double depth) {
    const double coverage = 1 - std::exp(-double(card.optical_depth));
    const glm::vec2 rg = glm::unpackHalf2x16(card.transmission.x),
                    b = glm::unpackHalf2x16(card.transmission.y);
    return {depth, 1.0 - coverage * (1.0 - glm::dvec3(rg.x, rg.y, b.x)), index};
  }
  static double depth_of(uint64_t key) {
    return double(std::bit_cast<float>(uint32_t(key >> 32) & ~shared::kTieMask));
  }
  static glm::dvec3 through_of(uint64_t key) {
    if (key & shared::kGrayLayer)
      return glm::dvec3(double(key & shared::kGraySteps) / double(shared::kGraySteps));
    return glm::dvec3(key & 1023, key >> 10 & 1023, key >> 20 & 1023) / 1023.0;
  }
  struct Layers {
    std::vector<uint64_t> keys;  // [layer][pixel]
    uint32_t merged;
    std::vector<uint32_t> tails;  // [pixel][word of a shared::LayerTail]
    bool operator==(const Layers&) const = default;
    shared::LayerTail tail(uint32_t pixel) const {
      shared::LayerTail one;
      std::memcpy(&one, &tails[pixel * sizeof one / 4], sizeof one);
      return one;
    }
  };
  Layers layers_of(const Stages& s) {
    const std::vector<uint32_t> words = s.words("layer_tails");
    return {gpu::read<uint64_t>(device, s.resources.buffer("layers")),
            words[0],
            {words.begin() + 1, words.end()}};
  }
  static glm::vec3 channel(int c) {
    glm::vec3 color(0.0f);
    color[c] = 0.9f;
    return color;
  }
  void add_sharp(float z, float optical_depth, glm::vec3 color) {
    PlacedCard card;
    card.z = z;
    card.optical_depth = optical_depth;
    card.color = color;
    card.layer = shared::kSolidLayer;
    add(card);
  }
  PlacedCard random_sharp() {
    return {.optical_depth = float(random.octaves(0.06, 6)),
            .transmission = random.one_in(2) ? glm::vec3(0.0f)
                                             : glm::vec3(random.f(0, 1), random.f(0, 1), random.f(0, 1)),
            .layer = random.one_in(2) ? shared::kSolidLayer : shared::kDiscLayer};
  }

  /// Slots and tail of every pixel against fragments cast here; pixels where single precision could order two
  /// fragments otherwise, or at the edge of a card, are left out.
  void expect_nearest(const Stages& s, size_t least_compared) {
    const Layers found = layers_of(s);
    const std::vector<shared::Card> all = cards();
    const uint32_t k = s.volume().exact_layers, pixels = size.x * size.y;
    const double near = double(view().near_m);
    const auto opaque = gpu::read<float>(device, s.world->targets.opaque_depth);
    size_t compared = 0;
    for (uint32_t i = 0; i < pixels; ++i) {
      const glm::dvec2 at = glm::dvec2(i % size.x, i / size.x) + 0.5;
      std::vector<Fragment> fragments;
      bool doubtful = false;
      for (uint32_t c = 0; c < all.size(); ++c) {
        const shared::Card& card = all[c];
        const auto depth = hit(card, at, 1e-4);
        doubtful = doubtful || depth.has_value() != hit(card, at, -1e-4).has_value();
        if (depth && *depth < near / std::max(double(opaque[i]), 1e-9))
          fragments.push_back(fragment_of(card, c, *depth));
      }
      std::ranges::sort(fragments, {}, &Fragment::depth);
      for (size_t f = 1; f < fragments.size(); ++f)
        doubtful = doubtful || fragments[f].depth - fragments[f - 1].depth < 2e-5 * fragments[f].depth;
      if (doubtful) continue;
      ++compared;
      glm::dvec3 tail(0.0);
      double places = 0;
      size_t rest = 0;
      for (size_t f = 0; f < std::max<size_t>(fragments.size(), k); ++f) {
        if (f >= k) {
          const glm::dvec3 t = fragments[f].through;
          const glm::dvec3 stored = t.r == t.g && t.g == t.b ? t : glm::round(t * 1023.0) / 1023.0;
          const glm::dvec3 tau = glm::min(-glm::log(glm::max(stored, 1.1e-7)), 8.0);
          tail += tau;
          places += (tau.r + tau.g + tau.b) / 3 * (std::log2(fragments[f].depth) + 8) / 32;
          ++rest;
          continue;
        }
        const uint64_t key = found.keys[f * pixels + i];
        if (f >= fragments.size()) {
          ASSERT_EQ(~uint64_t(0), key) << "pixel " << i << " slot " << f << " must be free";
          continue;
        }
        // Single precision, and the last bits of the depth that the index takes.
        ASSERT_NEAR(fragments[f].depth, depth_of(key), 1.3e-5 * fragments[f].depth)
            << "pixel " << i << " slot " << f;
        ASSERT_EQ(fragments[f].card & shared::kTieMask, uint32_t(key >> 32) & shared::kTieMask);
        for (int c = 0; c < 3; ++c)
          ASSERT_NEAR(fragments[f].through[c], through_of(key)[c], 0.501 / 1023)
              << "pixel " << i << " slot " << f;
      }
      const shared::LayerTail one = found.tail(i);
      if (rest == 0) {
        ASSERT_EQ(0u, one.before) << "pixel " << i;
        continue;
      }
      // A fragment's transmittance is one of 1024: a channel that rounds the other way is a step of one.
      const double step = double(rest) * 1e-4;
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(tail[c], double(one.depth[c]) / 32768, step + 0.02 * tail[c]) << "pixel " << i;
      ASSERT_NEAR(places, double(one.places) / 32768, step + 0.02 * places) << "pixel " << i;
      const auto depth_of_bits = [](uint32_t bits) { return double(std::bit_cast<float>(bits)); };
      ASSERT_NEAR(fragments[k].depth, depth_of_bits(~one.before), 1.3e-5 * fragments[k].depth);
      ASSERT_NEAR(fragments.back().depth, depth_of_bits(one.farthest), 1.3e-5 * fragments.back().depth);
    }
    EXPECT_GE(compared, least_compared);
  }
};

TEST_F(AvboitExactLayers, AreTheNearestFragmentsOfAPixel) {
  Solid wall;
  wall.position = {5, 0, -12};
  wall.size_m = {10, 30, 1};
  scene.solids = {wall};
  for (settings.exact_layers = 1; settings.exact_layers <= 3; ++settings.exact_layers) {
    clear_cards();
    for (int i = 0; i < 36; ++i) {
      PlacedCard card = random_sharp();
      const double z = random.octaves(1, 30);
      card.z = float(z);
      card.at = {z * random.between(-0.5, 0.5), z * random.between(-0.3, 0.3)};
      card.half_size = {z * random.octaves(0.1, 2), z * random.octaves(0.1, 2)};
      if (i % 3 == 0) card.yaw = random.f(-1.4, 1.4), card.pitch = random.f(-1.2, 1.2);
      add(card);
    }
    const Stages s = run_stages(settings, Until::kExactLayers);
    expect_nearest(s, 700);
    if (HasFatalFailure()) return;
  }
}

TEST_F(AvboitExactLayers, OfOneDepthHideEachOtherAsInTheReference) {
  clear_cards();
  PlacedCard smoke;  // before them
  smoke.z = 2;
  smoke.half_size = {9, 9};
  smoke.optical_depth = 0.7f;
  smoke.color = {0.3, 0.3, 0.3};
  add(smoke);
  for (int i = 0; i < 12; ++i) {
    PlacedCard card = random_sharp();
    card.z = 4;
    card.optical_depth = i % 3 == 0 ? 1.0f : 20.0f;
    card.transmission = glm::vec3(0.0f);
    card.color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
    card.half_size = {random.f(0.5, 3), random.f(0.5, 3)};
    card.at = {random.f(-1, 1), random.f(-1, 1)};
    add(card);
  }
  const auto exact = draw_cards("reference"), drawn = draw_cards("avboit", {{"exact_layers", "8"}});
  for (size_t i = 0; i < exact.linear.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      ASSERT_NEAR(exact.linear.pixels[i][c], drawn.linear.pixels[i][c], 3e-3) << "pixel " << i;
}

// Clear glass covers and lets everything pass, as the faint edge of a disc does.
TEST_F(AvboitExactLayers, ThatHideNothingAreLikeNone) {
  for (const size_t clear : {0u, 1u, 4u, 7u}) {
    clear_cards();
    for (size_t i = 0; i < clear; ++i)
      add({.z = 2 + 0.3f * float(i),
           .optical_depth = 1.0f,
           .transmission = glm::vec3(1.0f),
           .layer = shared::kSolidLayer});
    add({.z = 7, .optical_depth = 1.0f, .color = glm::vec3(0.5f)});
    add_sharp(8, 1.0f, glm::vec3(0.5f));
    const glm::vec3 pixel = draw_cards("avboit").linear.pixels[100];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(0.5 * (1 - std::exp(-2.0)), pixel[c], 0.002) << clear;
  }
}

TEST_F(AvboitExactLayers, BeyondTheLastTheNearestOpaqueCardIsSeen) {
  clear_cards();
  for (int i = 0; i < 6; ++i) add_sharp(2 + 0.2f * float(i), 0.06f, glm::vec3(0.0f));
  for (int c = 0; c < 3; ++c) add_sharp(4 + float(c), 8.0f, channel(c));
  const auto exact = draw_cards("reference").linear.pixels[100],
             drawn = draw_cards("avboit").linear.pixels[100];
  // Four thin panes are kept in front. Of the rest, the slab lets a few thousandths through to the second
  // opaque card.
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(exact[c], drawn[c], 0.01) << c;
}

TEST_F(AvboitExactLayers, BeyondTheLastOpaqueCardsOfOneDepthMixAndDoNotDarken) {
  clear_cards();
  for (int i = 0; i < 4; ++i) add_sharp(2 + 0.2f * float(i), 0.06f, glm::vec3(0.0f));
  for (int c = 0; c < 3; ++c) add_sharp(4, 8.0f, channel(c));
  for (const char* normalise : {"true", "false"}) {
    const glm::vec3 drawn = draw_cards("avboit", {{"normalise", normalise}}).linear.pixels[100];
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], 0.9 * std::exp(-0.24) / 3, 0.005) << c;
  }
}

TEST_F(AvboitExactLayers, BeyondTheLastEvenlySpacedPanesAreNearExact) {
  for (const bool coloured : {false, true}) {
    clear_cards();
    for (int i = 0; i < 60; ++i)
      add({.z = 3 + 0.05f * float(i),
           .optical_depth = 0.06f,
           .color = glm::mix(channel(0), channel(2), float(i) / 59),
           .transmission = coloured ? glm::vec3(0.9f, 0.5f, 0.0f) : glm::vec3(0.0f),
           .layer = shared::kSolidLayer});
    const auto exact = draw_cards("reference").linear.pixels[100],
               drawn = draw_cards("avboit").linear.pixels[100];
    // Red passes 0.994 of a coloured pane, in steps of 1/1023: a twelfth of its optical depth.
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(exact[c], drawn[c], coloured ? 0.06 : 0.01) << c;
  }
}

TEST_F(AvboitExactLayers, AreTheSameBitsInEveryOrderOfDraws) {
  for (settings.exact_layers = 1; settings.exact_layers <= 3; ++settings.exact_layers) {
    clear_cards();
    for (int i = 0; i < 30; ++i) {
      PlacedCard card = random_sharp();
      card.z = 3 + float(i / 3) * 0.5f;  // three at each depth: ties
      card.half_size = {random.f(1, 9), random.f(1, 9)};
      add(card);
    }
    const Layers in_order = layers_of(run_stages(settings, Until::kExactLayers));
    EXPECT_GT(in_order.merged, size.x * size.y * 10u);
    order.resize(30);
    std::iota(order.begin(), order.end(), 0u);
    for (int round = 0; round < 4; ++round) {
      if (round == 0)
        std::ranges::reverse(order);
      else
        random.shuffle(order);
      EXPECT_TRUE(in_order == layers_of(run_stages(settings, Until::kExactLayers)));
    }
  }
}

TEST_F(AvboitExactLayers, CountsWhatFallsOffTheEnd) {
  for (settings.exact_layers = 1; settings.exact_layers <= 3; ++settings.exact_layers) {
    clear_cards();
    for (int i = 0; i < 20; ++i)
      add({.z = 2 + float(i), .optical_depth = 0.2f, .layer = shared::kSolidLayer});
    const Stages s = run_stages(settings, Until::kExactLayers);
    EXPECT_EQ((20 - settings.exact_layer_count()) * size.x * size.y, layers_of(s).merged);
  }
}

TEST_F(AvboitExactLayers, MakeAPictureThatIsTheExactCompositeOfAsManyPanes) {
  scene.light.horizon = {0.3f, 0.5f, 0.7f};
  for (const uint32_t layers : {2u, 4u, 8u}) {
    clear_cards();
    for (uint32_t i = 0; i < layers; ++i) {
      PlacedCard card = random_sharp();
      card.layer = shared::kSolidLayer;
      card.z = 3 + random.f(0, 5);
      card.color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)};
      card.emission = i % 3 == 0 ? glm::vec3(0.2f, 0.1f, 0.3f) : glm::vec3(0.0f);
      add(card);
    }
    const DrawnPicture reference = draw_cards("reference"),
                       drawn = draw_cards("avboit", {{"exact_layers", std::to_string(layers)}});
    // Of each layer in front, the transmittance is rounded to one of 1023; sums to half floats.
    for (size_t i = 0; i < drawn.linear.pixels.size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(reference.linear.pixels[i][c], drawn.linear.pixels[i][c],
                    float(layers) * 0.5f / 1023 + 2.0f / 1024)
            << "pixel " << i;
  }
}

TEST_F(AvboitExactLayers, SharpAndSmoothCardsHideEachOther) {
  scene.light.horizon = {0.3f, 0.5f, 0.7f};
  for (int round = 0; round < 4; ++round) {
    clear_cards();
    for (int i = 0; i < 8; ++i) {
      const bool sharp = random.one_in(2);
      add({.z = 3 + float(i) + random.f(0, 0.5),
           .optical_depth = random.f(0.2, 1.5),
           .color = {random.f(0, 1), random.f(0, 1), random.f(0, 1)},
           .transmission = sharp && random.one_in(2) ? glm::vec3(0.9f, 0.3f, 0.1f) : glm::vec3(0.0f),
           .layer = sharp ? shared::kSolidLayer : 0});
    }
    // Smooth cards are some slices apart, so that the volume knows who is in front.
    const auto reference = draw_cards("reference").linear.pixels,
               drawn = draw_cards("avboit", {{"exact_layers", "8"}}).linear.pixels;
    for (size_t i = 0; i < drawn.size(); ++i)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(reference[i][c], drawn[i][c], 6.0f / 1024) << "pixel " << i;
  }
}

TEST_F(AvboitExactLayers, WhatIsBehindMoreLayersThanAreKeptIsHiddenByAllOfThem) {
  for (const uint32_t layers : {2u, 4u}) {
    clear_cards();
    double through = 1;
    for (int i = 0; i < 7; ++i) {
      const float tau = random.f(0.1, 0.4);
      through *= std::exp(-double(tau));
      add({.z = 3 + float(i) * 0.4f, .optical_depth = tau, .layer = shared::kSolidLayer});
    }
    add({.z = 9, .optical_depth = 0.7f, .color = glm::vec3(1.0f)});
    const double expected = through * (1 - std::exp(-0.7));
    for (const glm::vec3& pixel :
         draw_cards("avboit", {{"exact_layers", std::to_string(layers)}, {"normalise", "false"}})
             .linear.pixels)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(expected, double(pixel[c]), 3.0 / 1024);
  }
}

}  // namespace
}  // namespace plume
