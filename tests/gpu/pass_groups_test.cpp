// Every pass there is belongs to a group, so that no time is left over in the history of a method, and those
// that are not the method's own are known by name.
#include "sandbox/measure/pass_groups.h"

#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class PassGroups : public GpuTest, public testing::WithParamInterface<std::string> {};

TEST_P(PassGroups, HoldEveryPassOfTheMethod) {
  Scene scene = library.scene("haze");
  scene.depth_of_field = DepthOfField{};
  Stage stage(device, pipelines, library, scene);
  MethodInstance method = instance(GetParam());
  if (!method.method->missing(device).empty()) GTEST_SKIP() << "the device cannot run it";
  const Targets targets(device, {64, 36}, stage.post());
  auto passes = stage.go_to(240, targets.size);
  const auto report = render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), method);
  passes.insert(passes.end(), report.passes.begin(), report.passes.end());
  ASSERT_GT(passes.size(), 4u);
  for (const gpu::PassTime& pass : passes) EXPECT_TRUE(group_of(pass.name)) << pass.name;
  double own_ms = 0;
  for (const gpu::PassTime& pass : report.passes) own_ms += is_common(pass.name) ? 0 : pass.ms;
  EXPECT_NEAR(own_ms, report.transparency_ms, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(All, PassGroups, testing::ValuesIn(method_ids()),
                         [](const auto& of) { return of.param; });

}  // namespace
}  // namespace plume
