// The reference is drawn when what is shown has changed, and only then; and leaves no memory behind.
#include "sandbox/workspace/workspace.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class GroundTruthTest : public GpuTest {
 protected:
  static constexpr glm::uvec2 kArea{120, 68};

  void look_at(const char* view, Side& side) {
    side.view.choose(*Inspector::find(*side.method().method, view));
    workspace.change();
  }
  uint64_t drawings_after(const std::function<void()>& change) {
    change();
    workspace.draw(kArea);
    return workspace.truth().drawings();
  }
  uint64_t device_bytes() {
    const auto owners = device.memory().owners();
    const auto found = owners.find("ground truth");
    return found == owners.end() ? 0 : found->second;
  }

  Workspace workspace{device, pipelines, library, library.scene("quads_mcguire"), Playback(0, 60, false)};
};

TEST_F(GroundTruthTest, IsDrawnOnceForAsLongAsNothingOfThePictureChanges) {
  look_at("flip", workspace.a);
  look_at("difference", workspace.b);
  workspace.compare(Comparison::kSplit);
  EXPECT_EQ(drawings_after([] {}), 1u);
  EXPECT_EQ(drawings_after([&] { workspace.change(); }), 1u);
  EXPECT_EQ(drawings_after([&] { set_parameter(*workspace.a.method().method, "slices", "32"); }), 1u);
  EXPECT_EQ(drawings_after([&] { look_at("difference", workspace.a); }), 1u);
  EXPECT_EQ(drawings_after([&] { workspace.choose_method(workspace.a, workspace.b.current); }), 1u);
}

TEST_F(GroundTruthTest, IsDrawnAnewForAnotherPicture) {
  look_at("flip", workspace.a);
  EXPECT_EQ(drawings_after([] {}), 1u);
  EXPECT_EQ(drawings_after([&] { workspace.playback.go_to(7); }), 2u);
  CameraKey camera = workspace.camera();
  camera.position.x += 0.1f;
  EXPECT_EQ(drawings_after([&] { workspace.set_camera(camera); }), 3u);
  EXPECT_EQ(drawings_after([&] { workspace.resolution.set_step(2); }), 4u);
  EXPECT_EQ(drawings_after(
                [&] { workspace.change_scene([](Scene& scene) { scene.panes.at(0).position.z += 0.5f; }); }),
            5u);
}

TEST_F(GroundTruthTest, IsWhatItWouldBeIfDrawnEveryTime) {
  look_at("flip", workspace.a);
  workspace.draw(kArea);
  for (int i = 0; i < 2; ++i) {
    if (i == 1) set_parameter(*workspace.a.method().method, "slices", "64");
    workspace.draw(kArea);
    MethodInstance method = instance("avboit", i == 1 ? std::map<std::string, std::string>{{"slices", "64"}}
                                                      : std::map<std::string, std::string>{});
    const Prelude prelude = workspace.stage().prelude();
    const Inspected anew = Inspector().inspect(
        {device, pipelines, *workspace.a.targets, prelude, workspace.stage().transparents()}, method,
        *Inspector::find(*method.method, "flip"), 0);
    EXPECT_EQ(workspace.a.view.shown->values.pixels, anew.values.pixels) << i;
  }
}

TEST_F(GroundTruthTest, LeavesTheDeviceOnceThePictureStandsStillAndAllMemoryWithTheLastView) {
  look_at("flip", workspace.a);
  workspace.draw(kArea);
  EXPECT_GT(device_bytes(), 0u);  // the next picture may be another
  workspace.change();
  workspace.draw(kArea);
  EXPECT_EQ(device_bytes(), 0u);
  EXPECT_TRUE(workspace.truth().is_known());
  workspace.playback.go_to(3);
  workspace.draw(kArea);
  EXPECT_GT(device_bytes(), 0u);
  workspace.a.view.id.clear();
  workspace.draw(kArea);
  EXPECT_EQ(device_bytes(), 0u);
  EXPECT_FALSE(workspace.truth().is_known());
}

TEST_F(GroundTruthTest, ServesTheMeasurementsToo) {
  workspace.compares = true;
  workspace.draw(kArea);
  EXPECT_TRUE(workspace.measure_accuracy());
  workspace.draw(kArea);  // the side held the reference
  workspace.choose_method(workspace.a, workspace.b.current);
  workspace.draw(kArea);
  EXPECT_TRUE(workspace.measure_accuracy());
  EXPECT_EQ(workspace.accuracy().entries().size(), 2u);
  EXPECT_EQ(workspace.truth().drawings(), 1u);
}

}  // namespace
}  // namespace plume
