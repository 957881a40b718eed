// The order of the methods on the default scene, which is what the project claims.
#include "sandbox/measure/flip.h"
#include "sandbox/measure/metrics.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

using StreetTest = GpuTest;

TEST_F(StreetTest, AvboitIsNearerToTheReferenceThanEveryWboitWeight) {
  Stage stage(device, pipelines, library, library.scene("street"));
  const Targets targets(device, {640, 360});
  stage.go_to(stage.scene().default_tick, targets.size);
  const auto shot = [&](std::string_view id, const std::map<std::string, std::string>& settings) {
    MethodInstance method = instance(id, settings);
    return draw(stage, targets, method);
  };
  const DrawnPicture reference = shot("reference", {}), avboit = shot("avboit", {});
  const double avboit_rmse = rmse(reference.linear, avboit.linear);
  const double avboit_flip = flip(reference.display, avboit.display).mean;
  for (const char* weight : {"eq7", "eq8", "eq9", "eq10", "colour_aware", "learnopengl"}) {
    const DrawnPicture wboit = shot("wboit", {{"weight", weight}});
    EXPECT_LT(avboit_rmse, rmse(reference.linear, wboit.linear)) << weight;
    EXPECT_LT(avboit_flip, flip(reference.display, wboit.display).mean) << weight;
  }
}

TEST_F(StreetTest, OpaqueSmokeHidesThePeopleBehindIt) {
  // The smoke grenade's purpose: with both banks up, what stands behind their middle is gone from the exact
  // picture.
  Scene scene = library.scene("street");
  Stage with(device, pipelines, library, scene);
  const glm::uvec2 size{160, 90};
  const DrawnPicture smoky = draw(with, 600, size, "reference");
  Scene bare = scene;
  bare.instances.clear();
  Stage without(device, pipelines, library, bare);
  const DrawnPicture clear = draw(without, 600, size, "reference");
  size_t changed = 0;
  for (size_t i = 0; i < smoky.linear.pixels.size(); ++i)
    changed += glm::length(smoky.linear.pixels[i] - clear.linear.pixels[i]) > 0.05f;
  EXPECT_GT(changed, smoky.linear.pixels.size() / 10);
}

}  // namespace
}  // namespace plume
