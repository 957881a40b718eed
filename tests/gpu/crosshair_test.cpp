// The crosshair in a workspace: the panel's data without a window.
#include "sandbox/workspace/crosshair.h"

#include "sandbox/measure/pixel_probe_text.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

constexpr glm::uvec2 kSize{96, 54};

class CrosshairTest : public GpuTest {
 protected:
  Workspace workspace{device, pipelines, library, library.scene("three_cards"), Playback(0, 200, false)};
  Crosshair crosshair;

  void SetUp() override {
    workspace.resolution.adapts = false;
    workspace.draw(kSize);
    crosshair.place({48, 27}, kSize);
  }
};

TEST_F(CrosshairTest, TellsWhatIsAtThePixelOfTheMethodShown) {
  EXPECT_EQ(crosshair.stale_because(workspace), "not asked yet");
  crosshair.update(workspace, 0);
  ASSERT_TRUE(crosshair.told());
  EXPECT_EQ(crosshair.stale_because(workspace), "");

  Stage stage(device, pipelines, library, library.scene("three_cards"));
  const Targets targets(device, kSize);
  stage.go_to(0, kSize);
  MethodInstance avboit = instance("avboit");
  render_frame(device, pipelines, targets, stage.prelude(), stage.transparents(), avboit);
  PixelProbe expected = probe_pixel(device, pipelines, stage, targets, {48, 27});
  expected.methods.push_back(probe_method(device, pipelines, stage, targets, avboit, expected));
  EXPECT_EQ(to_json(*crosshair.told()), to_json(expected));
}

TEST_F(CrosshairTest, IsAskedAgainWhenItMovesAndWhenTheMethodChanges) {
  crosshair.update(workspace, 0);
  crosshair.move({-9, 0}, kSize);
  EXPECT_EQ(crosshair.stale_because(workspace), "of another pixel");
  crosshair.update(workspace, 0.001);  // the same picture: at once
  EXPECT_EQ(crosshair.told()->pixel, glm::uvec2(39, 27));

  workspace.change();
  EXPECT_EQ(crosshair.stale_because(workspace), "of an earlier picture");
  crosshair.update(workspace, 0.002);  // nothing is asked of what is about to change
  workspace.draw(kSize);
  crosshair.update(workspace, 0.003);
  EXPECT_EQ(crosshair.stale_because(workspace), "of an earlier picture") << "too soon after the last answer";
  crosshair.update(workspace, 0.5);
  EXPECT_EQ(crosshair.stale_because(workspace), "");
}

TEST_F(CrosshairTest, OtherMethodsWaitUntilThePictureStandsStill) {
  crosshair.ask_of_others(workspace, {"moments", "avboit"});
  crosshair.update(workspace, 0);
  EXPECT_EQ(crosshair.told()->methods.size(), 1u);
  EXPECT_EQ(crosshair.waiting(workspace), std::vector<std::string>{"moments"});  // avboit is shown
  crosshair.update(workspace, Crosshair::kStillSeconds + 0.01);
  EXPECT_TRUE(crosshair.waiting(workspace).empty());
  ASSERT_EQ(crosshair.told()->methods.size(), 2u);
  EXPECT_EQ(crosshair.told()->methods[1].id, "moments");
  EXPECT_EQ(crosshair.told()->methods[1].weights.size(), crosshair.told()->fragments.size());
}

TEST_F(CrosshairTest, BothSidesAreTold) {
  workspace.compare(Comparison::kSplit);
  workspace.draw(kSize);
  crosshair.update(workspace, 0);
  ASSERT_EQ(crosshair.told()->methods.size(), 2u);
  EXPECT_EQ(crosshair.told()->methods[1].name, workspace.b.method().owner);
}

TEST_F(CrosshairTest, LeavesNothingWhenItIsTakenAway) {
  const uint64_t before = device.memory().total_bytes();
  crosshair.ask_of_others(workspace, {"moments"});
  crosshair.update(workspace, 0);
  crosshair.update(workspace, 1);
  EXPECT_GT(device.memory().total_bytes(), before);
  crosshair.remove(workspace);
  EXPECT_EQ(device.memory().total_bytes(), before);
}

}  // namespace
}  // namespace plume
