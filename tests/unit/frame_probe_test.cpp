#include "sandbox/runs/frame_probe.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

using nlohmann::json;

/// At 1, 2, 3, … m, each letting `through` pass, seen on a grid from 0.5 m on.
PixelProbe stack(size_t count, glm::vec3 through) {
  PixelProbe probe{.pixel = {3, 4}};
  glm::vec3 weight(1.0f);
  for (size_t i = 0; i < count; ++i) {
    probe.fragments.push_back({.depth_m = float(i + 1), .transmittance = through, .weight = weight});
    weight *= through;
  }
  for (size_t i = 0; i < kEvenCurvePoints; ++i) probe.depths_m.push_back(0.5f + 0.031f * float(i));
  return probe;
}

TEST(FrameProbeTest, StepsStayStepsBetweenEvenPoints) {
  PixelProbe probe = stack(2, glm::vec3(0.5f));
  probe.depths_m = curve_depths(probe);
  EXPECT_EQ(probe.depths_m.size(), kEvenCurvePoints + 4);
  EXPECT_TRUE(std::ranges::is_sorted(probe.depths_m));
  const json told = frame_probe(probe, {.transmittance = std::vector(probe.depths_m.size(), glm::vec3(1))});
  std::vector<double> at_a_metre;
  for (size_t i = 0; i < probe.depths_m.size(); ++i)
    if (told["depth_m"][i] == 1.0) at_a_metre.push_back(told["exact"][i]);
  EXPECT_EQ(at_a_metre, (std::vector<double>{1.0, 0.5}));
  EXPECT_EQ(told["exact"].back(), 0.25);
}

TEST(FrameProbeTest, ManyFragmentsKeepTheStepsThatTakeMost) {
  PixelProbe probe = stack(1000, glm::vec3(0.999f));
  probe.fragments[700].transmittance = glm::vec3(0.0f);
  const std::vector<float> depths = curve_depths(probe);
  EXPECT_LE(depths.size(), kCurvePoints);
  EXPECT_GT(depths.size(), kCurvePoints - 8);
  for (const float kept : {1.0f, 50.0f, 701.0f})
    EXPECT_TRUE(std::ranges::binary_search(depths, kept)) << kept;
  EXPECT_FALSE(std::ranges::binary_search(depths, 500.0f));
}

TEST(FrameProbeTest, ColoursAreKeptWhereThereAreAny) {
  PixelProbe probe = stack(1, glm::vec3(1.0f, 0.5f, 0.5f));
  probe.depths_m = {0.5f, 2.0f};
  const MethodAtPixel gray{.transmittance = {glm::vec3(1.0f), glm::vec3(0.6f)}};
  json told = frame_probe(probe, gray);
  EXPECT_EQ(told["exact"], json::parse("[[1.0, 1.0, 1.0], [1.0, 0.5, 0.5]]"));
  EXPECT_EQ(told["transmittance"], json::parse("[[1.0, 1.0, 1.0], [0.6, 0.6, 0.6]]"));
  probe.fragments[0].transmittance = glm::vec3(0.5f);
  told = frame_probe(probe, gray);
  EXPECT_EQ(told["exact"], json::parse("[1.0, 0.5]"));
  EXPECT_EQ(told["transmittance"], json::parse("[1.0, 0.6]"));
}

TEST(FrameProbeTest, TellsDepthsThatAreThereOrNull) {
  PixelProbe probe = stack(0, glm::vec3(1));
  EXPECT_EQ(frame_probe(probe, {})["opaque_depth_m"], json());
  EXPECT_EQ(frame_probe(probe, {})["zero_depth_m"], json());
  probe.opaque_m = 7.0f;
  const json told = frame_probe(probe, {.marks = {.zero_m = 5.25f}});
  EXPECT_EQ(told["opaque_depth_m"], 7.0);
  EXPECT_EQ(told["zero_depth_m"], 5.25);
  EXPECT_EQ(told["pixel"], json::parse("[3, 4]"));
}

}  // namespace
}  // namespace plume
