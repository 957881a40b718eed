#include "sandbox/presets/add_instance.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEffect =
    "name = 'E'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 1]], life = 1}\nlook.opacity = 1\n";

class AddInstance : public testing::Test {
 protected:
  AddInstance() {
    fs::remove_all(root_);
    fs::create_directories(root_ / "effects");
    fs::create_directories(root_ / "scenes");
    std::ofstream(root_ / "effects/smoke.toml") << kEffect;
  }
  ~AddInstance() override { fs::remove_all(root_); }

  PresetDocument open(std::string_view text) const {
    std::ofstream(root_ / "scenes/s.toml") << text;
    return {root_ / "scenes/s.toml", PresetKind::kScene, PresetLibrary(root_)};
  }

  const fs::path root_ = fs::path(testing::TempDir()) / fmt::format("plume_add_instance_{}", ::getpid());
};

constexpr std::string_view kTop = R"(name = "S"   # kept
camera = { position = [0, 0, 5], target = [0, 0, 0] }
)";

TEST_F(AddInstance, StandsBehindTheOthersAndLeavesEveryOtherByte) {
  const std::string before =
      std::string(kTop) + "\n[[instance]]   # the first\neffect = \"smoke\"\n\n# at the end\n";
  PresetDocument scene = open(before);
  ASSERT_TRUE(
      add_instance(
          scene,
          {.name = "smoke 2", .effect = "smoke", .call_tick = 12, .position = {1.5f, 0, -2.25f}, .seed = 7})
          .made);
  EXPECT_EQ(scene.text(), std::string(kTop) +
                              "\n[[instance]]   # the first\neffect = \"smoke\"\n"
                              "\n[[instance]]\neffect = \"smoke\"\nname = \"smoke 2\"\ncall_tick = 12\n"
                              "position = [1.5, 0.0, -2.25]\nseed = 7\n\n# at the end\n");
  EXPECT_EQ(scene.undo_name(), "Add smoke 2");
  ASSERT_TRUE(scene.undo());
  EXPECT_EQ(scene.text(), before) << "one step";
}

TEST_F(AddInstance, IsTheFirstAndStandsInAnInlineListToo) {
  PresetDocument first = open(kTop);
  ASSERT_TRUE(add_instance(first, {.name = "smoke", .effect = "smoke", .call_tick = 0}).made);
  EXPECT_EQ(
      first.text(),
      std::string(kTop) + "\n[[instance]]\neffect = \"smoke\"\ncall_tick = 0\nposition = [0.0, 0.0, 0.0]\n");
  PresetDocument listed = open(std::string(kTop) + "instance = [{ effect = \"smoke\", name = \"a\" }]\n");
  ASSERT_TRUE(add_instance(listed, {.name = "b", .effect = "smoke", .call_tick = 3, .yaw_deg = 90}).made);
  ASSERT_EQ(listed.scene()->instances.size(), 2u);
  EXPECT_EQ(listed.scene()->instances[1].name, "b");
  EXPECT_EQ(listed.scene()->instances[1].call_tick, 3u);
  EXPECT_EQ(listed.scene()->instances[1].yaw_deg, 90);
}

TEST_F(AddInstance, IsRefusedWhereTheSceneWouldHaveAMistake) {
  PresetDocument scene = open(kTop);
  const auto outcome = add_instance(scene, {.name = "smoke", .effect = "smok", .call_tick = 0});
  EXPECT_FALSE(outcome.made);
  ASSERT_EQ(outcome.diagnostics.size(), 1u);
  EXPECT_NE(outcome.diagnostics[0].message.find("did you mean `smoke`?"), std::string::npos);
  EXPECT_EQ(scene.text(), kTop);
}

}  // namespace
}  // namespace plume
