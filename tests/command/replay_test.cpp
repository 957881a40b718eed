// plume replay: scripts played without a display, and the files they ask for.
#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

using Names = std::vector<std::string>;

class ReplayTest : public ProgramTest {
 protected:
  Outcome replay(const std::string& script, const Arguments& more = {}) {
    write("my script.toml", script);
    Arguments arguments{"replay", "./my script.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
};

constexpr const char* kSorted = "[[method]]\nid = 'sorted'\n";

TEST_F(ReplayTest, MeasuresEveryMethodOnEveryTickOfTheList) {
  const Outcome outcome =
      replay(street_script("[20, 60, 61]", "[[method]]\nid = 'sorted'\n[[method]]\nid = 'avboit'\n"));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = results();
  json order = json::array();
  for (const json& frame : all["frames"]) {
    order.push_back({frame["tick"], frame["method"]});
    EXPECT_EQ(frame["size"], json::parse("[48, 27]"));
  }
  EXPECT_EQ(order, json::parse(R"([[20, "sorted"], [20, "avboit"], [60, "sorted"], [60, "avboit"],
                                   [61, "sorted"], [61, "avboit"]])"));
  EXPECT_TRUE(says(outcome.err, {"[1/3]", "[2/3]", "[3/3]", "left"}));
  EXPECT_EQ(pictures().size(), 12u);
}

TEST_F(ReplayTest, PlaysARangeOfTicks) {
  ASSERT_EQ(replay(street_script("{first = 10, last = 20, step = 5}", kSorted)).exit_code, 0);
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 3u);
  EXPECT_EQ(all["frames"][2]["tick"], 20);
}

TEST_F(ReplayTest, MovesTheCameraBetweenItsKeys) {
  const std::string keys =
      "[[camera]]\ntick = 20\nposition = [0.3, 1.5, 5.4]\ntarget = [0, 1.6, -2]\nvertical_fov_deg = 46\n"
      "[[camera]]\ntick = 22\nposition = [3.3, 1.5, 5.4]\ntarget = [0, 1.6, -2]\nvertical_fov_deg = 46\n";
  const Outcome moved = replay(street_script("[20, 21, 22]", keys + kSorted), {"--out", "moved"});
  ASSERT_EQ(moved.exit_code, 0) << moved.err;
  ASSERT_EQ(replay(street_script("[20, 21, 22]", kSorted), {"--out", "still"}).exit_code, 0);
  // The smoke changes little in two ticks; the camera everything.
  const auto change = [&](const std::string& folder) {
    const Outcome outcome =
        run({"diff", folder + "/street_000020_sorted.png", folder + "/street_000022_sorted.png"});
    return json::parse(outcome.out).at("rmse").get<double>();
  };
  EXPECT_GT(change("moved"), 5 * change("still"));
}

TEST_F(ReplayTest, TellsSettingsOfOneMethodApart) {
  ASSERT_EQ(replay(street_script("[60]",
                                 "[capture]\nerror_maps = false\n[[method]]\nid = 'wboit'\nweight = 'eq7'\n"
                                 "[[method]]\nid = 'wboit'\nweight = 'eq10'\ndepth_scale = 0.5\n"))
                .exit_code,
            0);
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 2u);
  EXPECT_EQ(all["frames"][0]["settings"]["weight"], "eq7");
  EXPECT_EQ(all["frames"][0]["settings"]["depth_scale"], 1.0);
  EXPECT_EQ(all["frames"][1]["settings"]["weight"], "eq10");
  EXPECT_EQ(all["frames"][1]["settings"]["depth_scale"], 0.5);
  EXPECT_EQ(all["frames"][0]["image"], "street_000060_wboit-weight-eq7.png");
  EXPECT_EQ(all["frames"][1]["image"], "street_000060_wboit-depth_scale-0.5-weight-eq10.png");
  const auto drawn = pictures();
  ASSERT_EQ(drawn.size(), 2u);
  EXPECT_NE(drawn.begin()->second, drawn.rbegin()->second);
}

TEST_F(ReplayTest, CommandLineSetsWhatTheScriptLeavesOpen) {
  const std::string two = "[[method]]\nid = 'wboit'\nweight = 'eq7'\n[[method]]\nid = 'wboit'\n";
  ASSERT_EQ(replay(street_script("[60]", two), {"--set", "wboit.weight=eq9"}).exit_code, 0);
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 2u);
  EXPECT_EQ(all["frames"][0]["settings"]["weight"], "eq7");
  EXPECT_EQ(all["frames"][1]["settings"]["weight"], "eq9");
}

TEST_F(ReplayTest, CapturesOnlyTheTicksItIsAsked) {
  ASSERT_EQ(
      replay(street_script("[20, 40, 60]", "[capture]\nticks = [40]\n" + std::string(kSorted))).exit_code, 0);
  EXPECT_EQ(files(), (Names{"report.html", "results.csv", "results.json", "street_000040_sorted.png",
                            "street_000040_sorted_error.png"}));
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 3u);
  EXPECT_TRUE(all["frames"][0]["image"].is_null());
  EXPECT_TRUE(all["frames"][0]["error_map"].is_null());
  EXPECT_TRUE(all["frames"][0]["error"].is_object());  // measured nevertheless
  EXPECT_EQ(all["frames"][1]["image"], "street_000040_sorted.png");
}

TEST_F(ReplayTest, CapturesOnlyTheKindsItIsAsked) {
  ASSERT_EQ(replay(street_script("[40]", "[capture]\nimages = false\nerror_maps = false\nhdr = true\n" +
                                             std::string(kSorted)))
                .exit_code,
            0);
  EXPECT_EQ(files(), (Names{"report.html", "results.csv", "results.json", "street_000040_sorted.exr"}));
}

TEST_F(ReplayTest, WritesTheLinearImageAsExr) {
  ASSERT_EQ(replay(street_script("[400]", "[capture]\nhdr = true\n" + std::string(kSorted))).exit_code, 0);
  const Image linear = read_exr(at("out/street_000400_sorted.exr"));
  EXPECT_EQ(linear.width, 48);
  EXPECT_EQ(linear.height, 27);
  float brightest = 0;
  for (const auto& pixel : linear.pixels) brightest = std::max({brightest, pixel.r, pixel.g, pixel.b});
  EXPECT_GT(brightest, 1.0f);  // fire is brighter than a display
}

TEST_F(ReplayTest, DrawsShotsInTheirOrderEachAsItSays) {
  ASSERT_EQ(replay("name = 'R'\nscene = 'quads_mcguire'\nsize = [16, 9]\nframes = 1\nwarmup = 0\n"
                   "[capture]\nerror_maps = false\n[[method]]\nid = 'wboit'\n[[method]]\nid = 'sorted'\n"
                   "[[shot]]\ntick = 5\nmethod = 2\n[[shot]]\ntick = 5\nsize = [20, 9]\n"
                   "camera = {position = [0, 0, 9], target = [0, 1, 0]}\n"
                   "[[shot]]\ntick = 2\nmethod = 2\n[[shot]]\ntick = 5\nmethod = 2\n")
                .exit_code,
            0);
  const auto drawn = pictures();
  Names names;
  for (const auto& [name, bytes] : drawn) names.push_back(name);
  EXPECT_EQ(
      names,
      (Names{"shot_000001_quads_mcguire_000005_sorted.png", "shot_000002_quads_mcguire_000005_wboit.png",
             "shot_000003_quads_mcguire_000002_sorted.png", "shot_000004_quads_mcguire_000005_sorted.png"}));
  EXPECT_EQ(drawn.at(names[0]), drawn.at(names[3]));
  const json all = results();
  EXPECT_EQ(all["frames"][1]["size"], json::parse("[20, 9]"));
  EXPECT_EQ(all["frames"][1]["shot"], 2);
  ASSERT_EQ(run({"replay", "./my script.toml", "--resume", "--shard", "0/2"}).exit_code, 0);
  EXPECT_EQ(pictures(), drawn);
}

TEST_F(ReplayTest, PresetsInTheFolderOfItsNameComeFirst) {
  fs::create_directories(at("my script/scenes"));
  fs::copy_file(fs::path(PLUME_SOURCE_PRESETS) / "scenes/quads_mcguire.toml",
                at("my script/scenes/street.toml"));
  const std::string script = "name = 'R'\nsize = [16, 9]\nframes = 1\nticks = [0]\n" + std::string(kSorted);
  ASSERT_EQ(replay("scene = 'street'\n" + script, {"--out", "by id"}).exit_code, 0);
  ASSERT_EQ(replay("scene = 'scenes/street.toml'\n" + script, {"--out", "by path"}).exit_code, 0);
  ASSERT_EQ(replay("scene = 'quads_mcguire'\n" + script, {"--out", "library"}).exit_code, 0);
  EXPECT_EQ(read("by id/street_000000_sorted.png"), read("library/quads_mcguire_000000_sorted.png"));
  EXPECT_EQ(pictures("by id"), pictures("by path"));
}

TEST_F(ReplayTest, SeedOfTheCommandLineBeatsTheScripts) {
  const auto hash = [&](const std::string& seed, const Arguments& more) {
    EXPECT_EQ(replay(seed + street_script("[60]", kSorted), more).exit_code, 0);
    return demand_of_first()["state_hash"].get<std::string>();
  };
  const std::string three = hash("seed = 3\n", {});
  EXPECT_EQ(hash("seed = 3\n", {}), three);
  EXPECT_NE(hash("seed = 4\n", {}), three);
  EXPECT_EQ(hash("seed = 4\n", {"--seed", "3"}), three);
}

TEST_F(ReplayTest, SceneByPathGivesCleanFileNames) {
  fs::create_directories(at("my scenes"));
  fs::copy_file(fs::path(PLUME_SOURCE_PRESETS) / "scenes/quads_mcguire.toml", at("my scenes/cards.toml"));
  const Outcome outcome =
      replay("name = 'R'\nscene = 'my scenes/cards.toml'\nsize = [16, 9]\nticks = [0]\nframes = 1\n" +
             std::string(kSorted));
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results()["frames"][0]["scene"], "cards");
  EXPECT_EQ(files(), (Names{"cards_000000_sorted.png", "cards_000000_sorted_error.png", "report.html",
                            "results.csv", "results.json"}));
}

TEST_F(ReplayTest, MistakesOfALaterScriptAreFoundBeforeTheFirstIsDrawn) {
  write("first.toml", street_script("[20]", kSorted));
  write("second.toml", "name = 'R'\nscene = 'streat'\nticks = [0]\n" + std::string(kSorted));
  const Outcome outcome = run({"replay", "first.toml", "second.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"did you mean `street`?"}));
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(ReplayTest, ScriptsThatWouldOverwriteEachOtherAreRefused) {
  write("first.toml", street_script("[20]", kSorted));
  write("second.toml", "seed = 5\n" + street_script("[20]", kSorted));
  const Outcome outcome = run({"replay", "first.toml", "second.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"street at tick 20 with sorted is asked for twice"}));
}

}  // namespace
}  // namespace plume
