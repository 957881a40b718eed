// Finding presets in a folder, by id and by path, and checking files of any kind.
#include "sandbox/presets/library.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "sandbox/presets/check.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/presets/read_scene.h"

namespace plume {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kEffect =
    "name = 'E'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 1]], life = 1}\nlook.opacity = 1\n";
constexpr std::string_view kScene = "name = 'S'\ncamera = {position = [0, 0, 1], target = [0, 0, 0]}\n";
constexpr std::string_view kReplay = "name = 'R'\nscene = 'street'\nticks = [0]\n[[method]]\nid = 'wboit'\n";

class Library : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) /
            (std::string("plume_library_") + testing::UnitTest::GetInstance()->current_test_info()->name());
    fs::remove_all(root_);
    write("effects/smoke.toml", kEffect);
    write("effects/sparks.toml", kEffect);
    write("effects/notes.txt", "not a preset");
    write("scenes/street.toml", kScene);
    write("replays/first.toml", kReplay);
  }
  void TearDown() override { fs::remove_all(root_); }

  fs::path write(const std::string& path, std::string_view text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
    return root_ / path;
  }
  std::string error_of(PresetKind kind, std::string_view name) {
    try {
      library().find(kind, name);
    } catch (const PresetError& error) {
      return error.what();
    }
    return "no error";
  }
  PresetLibrary library() { return PresetLibrary(root_); }

  fs::path root_;
};

TEST_F(Library, ListsIdsSorted) {
  EXPECT_EQ(library().ids(PresetKind::kEffect), (std::vector<std::string>{"smoke", "sparks"}));
  EXPECT_EQ(library().ids(PresetKind::kScene), (std::vector<std::string>{"street"}));
  EXPECT_EQ(library().ids(PresetKind::kReplay), (std::vector<std::string>{"first"}));
  EXPECT_TRUE(PresetLibrary("/nowhere").ids(PresetKind::kScene).empty());
}

TEST_F(Library, FindsById) {
  EXPECT_EQ(library().effect("smoke").id, "smoke");
  EXPECT_EQ(library().scene("street").name, "S");
  EXPECT_EQ(library().replay("first").scene, "street");
}

TEST_F(Library, FindsByPath) {
  const fs::path elsewhere = write("elsewhere/mine.toml", kEffect);
  EXPECT_EQ(library().effect(elsewhere.string()).id, "mine");
}

TEST_F(Library, FindsWhatIsSavedLater) {
  const PresetLibrary early = library();
  EXPECT_THROW(early.find(PresetKind::kEffect, "late"), PresetError);
  write("effects/late.toml", kEffect);
  EXPECT_EQ(early.effect("late").id, "late");
}

TEST_F(Library, NamesTheNearestOfAnUnknownId) {
  EXPECT_EQ(error_of(PresetKind::kEffect, "smok"), "unknown effect `smok`, did you mean `smoke`?");
  EXPECT_EQ(error_of(PresetKind::kEffect, "xyz"), "unknown effect `xyz`, expected one of `smoke`, `sparks`");
  EXPECT_EQ(error_of(PresetKind::kScene, "smoke"), "unknown scene `smoke`, expected one of `street`");
  EXPECT_EQ(error_of(PresetKind::kScene, "no/street"),
            "there is no file no/street, expected a path to a scene");
  EXPECT_EQ(error_of(PresetKind::kScene, "street.toml"),
            "there is no file street.toml, expected a path to a scene");
}

TEST_F(Library, ReportsUnknownReferencesWhereTheyStand) {
  const std::string scene =
      std::string(kScene) + "[[instance]]\neffect = 'smoke'\n[[instance]]\neffect = 'sparsk'\n";
  const auto found = check_references(read_scene_text(scene, "s.toml"), library());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(to_string(found[0]), "s.toml:6:10: unknown effect `sparsk`, did you mean `sparks`?");

  EXPECT_TRUE(check_references(library().replay("first"), library()).empty());
  Replay replay = library().replay("first");
  replay.scene = "stret";
  ASSERT_EQ(check_references(replay, library()).size(), 1u);
  EXPECT_EQ(check_references(replay, library())[0].line, 2u);
}

TEST_F(Library, CheckKnowsTheKindByFolder) {
  EXPECT_TRUE(check_file(root_ / "effects/smoke.toml").empty());
  EXPECT_TRUE(check_file(root_ / "scenes/street.toml").empty());
  EXPECT_TRUE(check_file(root_ / "replays/first.toml").empty());
  EXPECT_FALSE(check_file(write("scenes/smoke.toml", kEffect)).empty());
}

TEST_F(Library, CheckKnowsTheKindByContentElsewhere) {
  EXPECT_TRUE(check_file(write("mine/a.toml", kEffect)).empty());
  EXPECT_TRUE(check_file(write("mine/b.toml", kScene)).empty());
  EXPECT_TRUE(check_file(write("mine/c.toml", kReplay)).empty());
  EXPECT_EQ(check_file(write("mine/d.toml", "name = ")).size(), 1u);
}

TEST_F(Library, CheckLooksReferencesUpInTheTreeOfTheFileOrTheLibrary) {
  const std::string scene = std::string(kScene) + "[[instance]]\neffect = 'smok'\n";
  EXPECT_EQ(check_file(write("scenes/bad.toml", scene)).size(), 1u);
  const fs::path loose = write("mine/bad.toml", scene);
  EXPECT_EQ(check_file(loose).size(), 0u);
  const PresetLibrary known = library();
  EXPECT_EQ(check_file(loose, &known).size(), 1u);
}

TEST_F(Library, CheckTellsAScenesInstanceThatItBearsTooManyOnItsWay) {
  write("effects/trail.toml",
        "name = 'T'\n[[emitter]]\nname = 'wake'\nspawn = {per_metre = 1000, life = 60}\nlook.opacity = 1\n");
  const auto on_a_way = [&](const std::string& keys) {
    return check_file(
        write("scenes/way.toml",
              std::string(kScene) + "[[instance]]\neffect = 'trail'\ncall_tick = 0\npath = " + keys + "\n"));
  };
  EXPECT_TRUE(on_a_way("[[0, [0, 0, 0]], [60, [3999, 0, 0]]]").empty());
  EXPECT_TRUE(on_a_way("[[0, [0, 0, 0]], [120, [7000, 0, 0]]]").empty()) << "half of them at once";
  const auto at_once = on_a_way("[[0, [0, 0, 0]], [60, [4001, 0, 0]]]");
  ASSERT_EQ(at_once.size(), 1u);
  EXPECT_EQ(at_once[0].line, 4u);
  EXPECT_EQ(at_once[0].column, 10u);
  EXPECT_EQ(at_once[0].message,
            "`wake` of effect `trail`: 4001000 particles are alive at once, expected at most 4000000: a "
            "shorter or slower `path`, or a lower `per_metre` or `life`");
  std::string there_and_back = "[[0, [0, 0, 0]]";
  for (int i = 1; i <= 300; ++i)
    there_and_back += fmt::format(", [{}, [{}, 0, 0]]", 10'000 * i, i % 2 * 20'000 - 10'000);
  const auto in_all = on_a_way(there_and_back + "]");
  ASSERT_EQ(in_all.size(), 1u);
  EXPECT_NE(in_all[0].message.find("particles are born in all, expected at most 4294967295"),
            std::string::npos)
      << in_all[0].message;
}

TEST_F(Library, CheckTellsASceneWhoseInstancesAreTogetherTooMany) {
  write("effects/burst.toml",
        "name = 'B'\n[[emitter]]\nname = 'e'\nspawn = {bursts = [[0, 2500000]], life = 60}\nlook.opacity = "
        "1\n");
  const auto called_again = [&](const std::string& keys) {
    return check_file(
        write("scenes/bursts.toml", std::string(kScene) + "[[instance]]\neffect = 'smoke'\ncall_tick = 5\n" +
                                        "[[instance]]\neffect = 'burst'\nname = 'a'\ncall_tick = 100\n" +
                                        "[[instance]]\neffect = 'burst'\nname = 'b'\n" + keys));
  };
  EXPECT_TRUE(called_again("").empty()) << "not called";
  EXPECT_TRUE(called_again("call_tick = 160\n").empty()) << "when the others are gone";
  EXPECT_TRUE(called_again("call_tick = 40\n").empty()) << "gone before the others";
  for (const char* keys :
       {"call_tick = 159\n", "call_tick = 41\n", "call_tick = 40\nfreeze = [[50, 51]]\n"}) {
    const auto found = called_again(keys);
    ASSERT_EQ(found.size(), 1u) << keys;
    EXPECT_NE(found[0].message.find("5000000 particles need room at tick"), std::string::npos)
        << found[0].message;
    EXPECT_NE(found[0].message.find("expected at most 4000000"), std::string::npos);
  }
  EXPECT_EQ(called_again("call_tick = 159\n")[0].line, 11u);
  EXPECT_EQ(called_again("call_tick = 41\n")[0].line, 7u) << "with which there are too many";
  write("effects/burst.toml",
        "name = 'B'\noff_screen = 'pause'\n[[emitter]]\nname = 'e'\n"
        "spawn = {bursts = [[0, 2500000]], life = 60}\nlook.opacity = 1\n");
  EXPECT_EQ(called_again("call_tick = 7000\n").size(), 1u) << "the first may not have been seen yet";
}

TEST_F(Library, CheckReportsAFileThatIsNotThere) {
  ASSERT_EQ(check_file(root_ / "scenes/none.toml").size(), 1u);
  EXPECT_EQ(check_file(root_ / "scenes").size(), 1u);
}

TEST_F(Library, RootIsWhatTheEnvironmentNames) {
  setenv("PLUME_PRESETS", root_.c_str(), 1);
  EXPECT_EQ(preset_root(), root_);
  setenv("PLUME_PRESETS", "/nowhere", 1);
  EXPECT_THROW(preset_root(), PresetError);
  unsetenv("PLUME_PRESETS");
  EXPECT_TRUE(fs::is_directory(preset_root()));
}

}  // namespace
}  // namespace plume
