// A scene that is changed while it is shown: what one sees is what its text says, and the text is what is
// saved.
#include "sandbox/presets/diagnostics.h"
#include "sandbox/workspace/living_particles.h"
#include "sandbox/workspace/seen_place.h"
#include "tests/gpu/workspace_test.h"

namespace plume {
namespace {

constexpr std::string_view kEffect = R"(name = "Small"
[[emitter]]
name = "puffs"
  [emitter.spawn]
  rate = 60.0
  duration = 100
  life = [20, 40]
  [emitter.shape]
  kind = "sphere"
  radius_m = 0.5
  [emitter.motion]
  speed = [0.5, 1.0]
  [emitter.look]
  radius_m = 0.2
  opacity = 0.9
)";

constexpr std::string_view kScene = R"(name = "Two"   # kept
duration_ticks = 200
[camera]
position = [0.0, 1.0, 6.0]
target = [0.0, 1.0, 0.0]
[[solid]]
kind = "plane"
size_m = [40.0, 40.0]
[[instance]]
name = "left"   # the first
effect = "small"
call_tick = 0
position = [-1.5, 1.0, 0.0]
[[instance]]
name = "right"
effect = "small"
call_tick = 5
position = [1.5, 1.0, 0.0]
seed = 2
)";

class SceneEditsTest : public WorkspaceTest {
 protected:
  SceneEditsTest() {
    write("effects/small.toml", kEffect);
    write("scenes/two.toml", kScene);
  }

  Workspace open(const std::string& scene = "two") { return WorkspaceTest::open(presets_.scene(scene)); }
  /// Of a scene with this text, opened anew.
  uint64_t anew(const std::string& text) {
    write("scenes/anew.toml", text);
    Workspace workspace = open("anew");
    return seen(workspace);
  }
};

TEST_F(SceneEditsTest, WhatIsDroppedMovedAndRemovedIsTheSavedFileOpenedAnew) {
  Workspace workspace = open();
  const uint64_t before = seen(workspace);
  PresetDocument& text = *workspace.scene_document();
  ASSERT_TRUE(workspace.drop_effect("small", {0.5f, 0.9f}));
  workspace.playback.go_to(90);
  const uint64_t dropped = seen(workspace);
  EXPECT_TRUE(workspace.stage().demand()[2].awake);
  ASSERT_TRUE(text.set("instance[0].position", glm::vec3(-1, 2, 0)).made);
  EXPECT_TRUE(workspace.advance(0)) << "the picture is out of date";
  const uint64_t moved = seen(workspace);
  EXPECT_NE(moved, dropped);
  ASSERT_TRUE(text.remove("instance[1]").made);
  const uint64_t removed = seen(workspace);
  EXPECT_NE(removed, moved);
  ASSERT_EQ(workspace.scene().instances.size(), 2u);
  EXPECT_EQ(workspace.scene().instances[1].name, "small");
  EXPECT_EQ(read("scenes/two.toml"), kScene) << "nothing is saved yet";
  EXPECT_EQ(workspace.scenes.unsaved().size(), 1u);

  workspace.scenes.save(workspace.scene().file, PresetDocument::OverChanges::kRefuse);
  EXPECT_TRUE(workspace.scenes.unsaved().empty());
  const std::string saved = read("scenes/two.toml");
  EXPECT_NE(saved.find("\"Two\"   # kept"), std::string::npos);
  EXPECT_NE(saved.find("\"left\"   # the first"), std::string::npos);
  EXPECT_NE(saved.find("call_tick = 50\n"), std::string::npos);
  workspace.playback.go_to(50);
  EXPECT_EQ(seen(workspace), anew(saved));

  for (int steps = 0; steps < 3; ++steps) ASSERT_TRUE(text.undo());
  EXPECT_FALSE(text.undo());
  EXPECT_EQ(before, seen(workspace));
}

TEST_F(SceneEditsTest, WhatIsNotTouchedIsNotBroughtFromItsBirthAgain) {
  Workspace workspace = open();
  workspace.draw(kSize);
  PresetDocument& text = *workspace.scene_document();
  ASSERT_TRUE(text.set("instance[1].position", glm::vec3(2, 1, 0)).made);
  workspace.draw(kSize);
  EXPECT_EQ(workspace.stage().demand()[0].ticks_simulated, 0u);
  EXPECT_GT(workspace.stage().demand()[1].ticks_simulated, 0u);
  ASSERT_TRUE(text.remove("instance[0]").made);
  workspace.draw(kSize);
  EXPECT_EQ(workspace.stage().demand()[0].ticks_simulated, 0u) << "the second is the first now";
  ASSERT_TRUE(text.set("instance[0].effect", std::string("small")).made);
  ASSERT_TRUE(text.undo());
  workspace.draw(kSize);
  EXPECT_EQ(workspace.stage().demand()[1].ticks_simulated, 0u);
}

TEST_F(SceneEditsTest, SwitchesStayWithTheirInstances) {
  Workspace workspace = open();
  workspace.switches.muted = {1};
  seen(workspace);
  PresetDocument& text = *workspace.scene_document();
  ASSERT_TRUE(text.remove("instance[0]").made);
  seen(workspace);
  EXPECT_EQ(workspace.switches.muted, std::set<size_t>{0});
  EXPECT_EQ(workspace.stage().demand()[0].why, "muted");
}

TEST_F(SceneEditsTest, UndoTakesBackWhatWasDoneLastToTheSceneOrTheEffect) {
  Workspace workspace = open();
  PresetDocument& effect = workspace.documents.open("small");
  ASSERT_TRUE(effect.set("emitter[0].shape.radius_m", 0.7f).made);
  ASSERT_TRUE(workspace.scene_document()->set("instance[0].yaw_deg", 30.0f).made);
  ASSERT_TRUE(effect.set("emitter[0].shape.radius_m", 0.9f).made);
  EXPECT_EQ(workspace.to_undo(""), workspace.scene_document()) << "no effect is worked on";
  for (PresetDocument* expected : {&effect, workspace.scene_document(), &effect}) {
    ASSERT_EQ(workspace.to_undo("small"), expected);
    ASSERT_TRUE(expected->undo());
  }
  EXPECT_EQ(workspace.to_undo("small"), nullptr);
  for (PresetDocument* expected : {&effect, workspace.scene_document(), &effect}) {
    ASSERT_EQ(workspace.to_redo("small"), expected);
    ASSERT_TRUE(expected->redo());
  }
  EXPECT_EQ(workspace.to_redo("small"), nullptr);
}

TEST_F(SceneEditsTest, ACopyIsWorkedOnFromThenOnAndTheFirstStaysAsItWas) {
  Workspace workspace = open();
  ASSERT_TRUE(workspace.scene_document()->remove("instance[1]").made);
  const uint64_t removed = seen(workspace);
  for (const char* name : {"", "two", "a/b", "a b"})
    EXPECT_THROW(workspace.save_scene_as(name), std::invalid_argument) << name;
  workspace.save_scene_as("one");
  EXPECT_EQ(workspace.scene().id, "one");
  EXPECT_EQ(removed, seen(workspace));
  EXPECT_EQ(read("scenes/two.toml"), kScene);
  EXPECT_EQ(workspace.scene_document()->path(), root_ / "scenes/one.toml");
  EXPECT_TRUE(workspace.scenes.unsaved().empty());
  EXPECT_EQ(presets_.scene("one").name, "one");
  EXPECT_EQ(presets_.scene("one").instances.size(), 1u);
  workspace.open_scene("two");
  EXPECT_EQ(workspace.scene().instances.size(), 2u);
}

TEST_F(SceneEditsTest, WhatIsNotSavedOutlivesAnotherScene) {
  write("scenes/other.toml", kScene);
  Workspace workspace = open();
  ASSERT_TRUE(workspace.scene_document()->remove("instance[1]").made);
  workspace.open_scene("other");
  EXPECT_EQ(workspace.scene().instances.size(), 2u);
  workspace.open_scene("two");
  EXPECT_EQ(workspace.scene().instances.size(), 1u);
  EXPECT_EQ(workspace.scene_document()->undo_name(), "Remove right");
}

TEST_F(SceneEditsTest, AFileThatIsChangedOnDiskIsShownAndABrokenOneKeepsTheLastGood) {
  Workspace workspace = open();
  workspace.advance(0);
  const uint64_t before = seen(workspace);
  write("scenes/two.toml", with(kScene, "[1.5, 1.0, 0.0]", "[1.5, oops, 0.0]"));
  workspace.advance(1);
  EXPECT_EQ(before, seen(workspace));
  ASSERT_EQ(workspace.scene_document()->diagnostics().size(), 1u);
  EXPECT_EQ(workspace.scene_document()->diagnostics()[0].line, 18u);
  const std::string lower = with(kScene, "duration_ticks = 200", "duration_ticks = 30");
  write("scenes/two.toml", lower);
  EXPECT_TRUE(workspace.advance(2));
  const uint64_t reloaded = seen(workspace);
  EXPECT_EQ(workspace.playback.tick(), 30u) << "the scene ends there";
  workspace.playback.go_to(20);
  EXPECT_NE(reloaded, seen(workspace));
}

TEST_F(SceneEditsTest, TheSeedThatWasAskedForStays) {
  Scene scene = presets_.scene("two");
  scene.seed = 77;
  Workspace workspace(device, pipelines, presets_, scene, Playback(50, 200, false));
  seen(workspace);
  ASSERT_TRUE(workspace.scene_document()->remove("instance[1]").made);
  seen(workspace);
  EXPECT_EQ(workspace.scene().instances.size(), 1u);
  EXPECT_EQ(workspace.scene().seed, 77u);
}

TEST_F(SceneEditsTest, ASurfaceHasANormalAndIsReadOncePerPicture) {
  Workspace workspace = open();
  workspace.draw(kSize);
  const auto floor = workspace.surface_at({0.3f, 0.9f});
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->position.y, 0, 1e-3f);
  EXPECT_NEAR(floor->normal.y, 1, 1e-2f);
  EXPECT_FALSE(workspace.surface_at({0.3f, 0.1f}));
  CameraKey camera = workspace.camera();
  camera.position.y = camera.target.y = 3;
  workspace.set_camera(camera);
  workspace.draw(kSize);
  const auto from_above = workspace.surface_at({0.3f, 0.9f});
  ASSERT_TRUE(from_above);
  EXPECT_NEAR(from_above->position.y, 0, 1e-3f) << "of the new picture, by its own camera";
  EXPECT_GT(glm::length(from_above->position - floor->position), 0.5f);
}

TEST_F(SceneEditsTest, ALookAtSmokeMeetsItsInstanceAndItsBallHoldsIt) {
  Workspace workspace = open();
  workspace.draw(kSize);
  const auto place = place_of(workspace.drawn_view(), {-1.5f, 1, 0});
  ASSERT_TRUE(place);
  const auto smoke = seen_at(workspace, *place);
  ASSERT_TRUE(smoke);
  EXPECT_EQ(smoke->instance, "left");
  EXPECT_NEAR(glm::length(smoke->position - glm::vec3(-1.5f, 1, 0)), 0.5f, 0.9f);
  const auto floor = seen_at(workspace, {0.5f, 0.98f});
  ASSERT_TRUE(floor);
  EXPECT_EQ(floor->instance, "");
  EXPECT_NEAR(floor->position.y, 0, 1e-3f);
  EXPECT_FALSE(seen_at(workspace, {0.5f, 0.02f})) << "the sky";

  const Ball ball = ball_round(workspace.stage(), 0);
  EXPECT_NEAR(glm::length(ball.centre - glm::vec3(-1.5f, 1, 0)), 0, 0.4f);
  size_t inside = 0, all = 0;
  const auto positions = living_positions(workspace.stage(), 0);
  for (const glm::vec3& position : positions.at(0)) {
    ++all;
    inside += glm::length(position - ball.centre) < ball.radius_m;
  }
  EXPECT_GT(all, 20u);
  EXPECT_GE(inside * 10, all * 9);
  EXPECT_LT(ball.radius_m, 2.5f);
  workspace.playback.go_to(0);
  workspace.draw(kSize);
  EXPECT_EQ(ball_round(workspace.stage(), 1).radius_m, 1) << "nothing lives yet";
}

}  // namespace
}  // namespace plume
