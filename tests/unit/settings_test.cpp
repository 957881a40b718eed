// What is kept from one session to the next.
#include "sandbox/workspace/settings.h"

#include <gtest/gtest.h>

#include <fstream>

#include "sandbox/measure/file_bytes.h"
#include "sandbox/presets/diagnostics.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

Settings chosen() {
  Settings settings{.scene = "glass",
                    .recent_scenes = {"glass", "/home/a b/my \"scene\".toml"},
                    .window_size = {1000, 700},
                    .window_corner = glm::ivec2(-5, 40),
                    .full_screen = true,
                    .panels = false,
                    .text_scale = 1.375f,
                    .holds_rate = false,
                    .frames_per_second = 24.5f,
                    .resolution_step = 3};
  settings.a = {.method = "wboit",
                .parameters = {{"wboit", {{"weight", "eq9"}}}, {"avboit", {{"slices", "32"}}}}};
  settings.b.method = "reference";
  return settings;
}

void expect_same(const Settings& a, const Settings& b) {
  EXPECT_EQ(a.scene, b.scene);
  EXPECT_EQ(a.recent_scenes, b.recent_scenes);
  EXPECT_EQ(a.window_size, b.window_size);
  EXPECT_EQ(a.window_corner, b.window_corner);
  EXPECT_EQ(a.full_screen, b.full_screen);
  EXPECT_EQ(a.panels, b.panels);
  EXPECT_EQ(a.text_scale, b.text_scale);
  EXPECT_EQ(a.holds_rate, b.holds_rate);
  EXPECT_EQ(a.frames_per_second, b.frames_per_second);
  EXPECT_EQ(a.resolution_step, b.resolution_step);
  EXPECT_EQ(a.a.method, b.a.method);
  EXPECT_EQ(a.a.parameters, b.a.parameters);
  EXPECT_EQ(a.b.method, b.b.method);
  EXPECT_EQ(a.b.parameters, b.b.parameters);
}

class SettingsFile : public testing::Test {
 protected:
  SettingsFile() { fs::remove_all(folder_); }
  ~SettingsFile() override { fs::remove_all(folder_); }

  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("plume_settings_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::path file_ = folder_ / "a/settings.toml";
};

TEST_F(SettingsFile, ComesBackAsItWasKept) {
  save_settings(file_, chosen());
  expect_same(load_settings(file_), chosen());
  save_settings(file_, Settings());
  expect_same(load_settings(file_), Settings());
}

TEST_F(SettingsFile, ThatIsNotThereGivesTheDefaults) {
  expect_same(load_settings(file_), Settings());
}

TEST_F(SettingsFile, ThatIsBrokenIsPutAsideAndNotLost) {
  save_settings(file_, chosen());
  for (const char* broken :
       {"", "scene = ", "\xff\xfe\x00x", "scene = 3", "unknown = 1", "[window]\nsize = [0, -1]\n",
        "[window]\ntext_scale = 0.01\n", "[window]\nx = 3\n", "[resolution]\nstep = 7\n", "a = 1\n"}) {
    std::ofstream(file_, std::ios::binary) << broken;
    EXPECT_THROW(load_settings(file_), FileErrors) << broken;
    EXPECT_NE(put_aside(file_).find(file_.string() + ".broken"), std::string::npos);
    EXPECT_FALSE(fs::exists(file_));
    const auto kept = read_file(file_.string() + ".broken");
    EXPECT_EQ(std::string(kept.begin(), kept.end()), broken);
    expect_same(load_settings(file_), Settings());
  }
}

TEST_F(SettingsFile, ThatCannotBeWrittenIsAnErrorThatNamesIt) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "a") << "a file where the folder should be";
  EXPECT_THROW(save_settings(file_, chosen()), FileError);
}

TEST(RecentScenes, AreEachOnceTheLastOneFirst) {
  Settings settings;
  for (const char* scene : {"a", "b", "a", "c", "c"}) visit_scene(settings, scene);
  EXPECT_EQ(settings.scene, "c");
  EXPECT_EQ(settings.recent_scenes, (std::vector<std::string>{"c", "a", "b"}));
}

TEST(RecentScenes, AreNoMoreThanAFileMayHave) {
  Settings settings;
  for (int i = 0; i < 100; ++i) visit_scene(settings, std::to_string(i));
  expect_same(read_settings_text(settings_text(settings), "x"), settings);
  EXPECT_EQ(settings.recent_scenes.front(), "99");
}

}  // namespace
}  // namespace plume
