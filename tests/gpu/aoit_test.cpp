#include "tests/gpu/pixel_nodes_test.h"

namespace plume {
namespace {

class AoitTest : public PixelNodesTest {};

TEST_F(AoitTest, UpToKLayersAreExact) {
  for (uint32_t count = 0; count <= 8; ++count) {
    SCOPED_TRACE(testing::Message() << "layers " << count);
    random_stack(count);
    expect_everywhere(draw_cards("aoit"), composite(sorted_stack(), background()));
  }
}

TEST_F(AoitTest, BeyondKTheTwoFarthestStepsAreOneAtTheNearer) {
  for (const int k : {1, 2, 3, 8, 32})
    for (int round = 0; round < 6; ++round) {
      SCOPED_TRACE(testing::Message() << "nodes " << k << ", round " << round);
      random_stack(random.below(48));
      const AoitModel model(arrivals(), size_t(k));
      expect_everywhere(draw_cards("aoit", {{"nodes", std::to_string(k)}}, true),
                        model.image(stack(), background()));
    }
}

// Merging the furthest keeps the nearer depth, so what comes when is forgotten.
TEST_F(AoitTest, TheOrderOfFragmentsDoesNotMatter) {
  for (int round = 0; round < 6; ++round) {
    random_stack(40);
    const glm::dvec3 sorted_first = AoitModel(sorted_stack(), 4).image(stack(), background());
    expect_everywhere(draw_cards("aoit", {{"nodes", "4"}}), sorted_first);
  }
}

// The known failure: an opaque layer that shares the last step with a thin one in front is dimmed by itself.
TEST_F(AoitTest, BehindTheLastStepEverythingDimsItself) {
  add({.z = 2, .optical_depth = depth_for(0.1f)});
  add({.z = 3, .optical_depth = depth_for(0.1f)});
  add({.z = 4, .optical_depth = shared::kOpaqueDepth, .color = {0.8f, 0.8f, 0.8f}});
  EXPECT_NEAR(draw_cards("reference").linear.pixels[0].g, 0.648f, 1e-3f);
  EXPECT_NEAR(draw_cards("aoit", {{"nodes", "3"}}).linear.pixels[0].g, 0.648f, 1e-3f);
  EXPECT_LT(draw_cards("aoit", {{"nodes", "2"}}).linear.pixels[0].g, 1e-3f);
}

TEST_F(AoitTest, WhatCoversNothingTakesNoStepAndIsDimmedAtItsDepth) {
  for (int i = 0; i < 20; ++i) add({.z = 2.5f, .optical_depth = 0, .emission = {0.05f, 0.1f, 0.2f}});
  add({.z = 2, .optical_depth = depth_for(0.5f)});
  add({.z = 3, .optical_depth = depth_for(0.5f)});
  const glm::dvec3 expected = 0.5 * 20.0 * glm::dvec3(0.05, 0.1, 0.2) + 0.25 * background();
  const Told told = ask("aoit", {{"nodes", "2"}}, {});
  EXPECT_EQ(told.statistics["merged_fragments"], 0);
  const auto drawn = draw_cards("aoit", {{"nodes", "2"}}).linear.pixels[0];
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c], expected[c], 2e-3);
}

TEST_F(AoitTest, TheProbeTellsTheVisibilityThatFragmentsAreGiven) {
  random_stack(24, true);
  const AoitModel model(arrivals(), 5);
  std::vector<float> depths;
  for (int i = 0; i < 48; ++i) depths.push_back(1.9f + 0.25f * float(i));  // between the layers' depths
  const Told told = ask("aoit", {{"nodes", "5"}}, depths);
  for (size_t i = 0; i < depths.size(); ++i) {
    const glm::dvec3 expected = model.visibility({.z = double(depths[i]), .id = 0, .light = {}, .t = {}});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(told.transmittance[i][c], expected[c], 1e-5) << depths[i];
  }
}

TEST_F(AoitTest, MergedFragmentsAreCounted) {
  for (int i = 0; i < 11; ++i) add({.z = float(2 + i % 5), .optical_depth = 0.2f});
  const auto counts = ask("aoit", {{"nodes", "4"}}, {}).statistics;
  EXPECT_EQ(counts["merged_fragments"], 7 * size.x * size.y);
  EXPECT_EQ(counts["pixels_with_merges"], size.x * size.y);
}

}  // namespace
}  // namespace plume
