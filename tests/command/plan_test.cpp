// What a run is going to draw, told before it is drawn and without a device; and one job of it alone.
#include <set>

#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

namespace plume {
namespace {

using Names = std::vector<std::string>;

class PlanTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write(
        "my script.toml",
        street_script("[20, 60]", "[[method]]\nid = 'sorted'\n[[method]]\nid = 'wboit'\nweight = 'eq10'\n"));
  }
  Outcome replay(const Arguments& more, const Environment& environment = {}) {
    Arguments arguments{"replay", "my script.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, environment);
  }
  const Environment no_device_{{"VK_ICD_FILENAMES", "/nonexistent"}};
};

TEST_F(PlanTest, ListsTheJobsWithoutADevice) {
  const Outcome outcome = replay({"--list", "--seed", "7"}, no_device_);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  Names ids;
  for (std::string line; std::getline(lines, line);) ids.push_back(line.substr(0, line.find(' ')));
  EXPECT_EQ(ids, (Names{"job", "street_000020_sorted", "street_000020_wboit-weight-eq10",
                        "street_000060_sorted", "street_000060_wboit-weight-eq10"}));
  EXPECT_TRUE(says(outcome.out, {"48x27", " 7 ", "weight=eq10"}));
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(PlanTest, ListsTheJobsAsJson) {
  const json list = json::parse(replay({"--list", "--json"}, no_device_).out);
  EXPECT_EQ(list["plan"]["jobs"], 4);
  EXPECT_EQ(list["jobs"].size(), 4u);
  EXPECT_EQ(list["jobs"][3], json::parse(R"({"job": "street_000060_wboit-weight-eq10", "scene": "street",
      "tick": 60, "shot": null, "size": [48, 27], "seed": 1, "method": "wboit", "settings": {"weight": "eq10"}})"));
}

TEST_F(PlanTest, IsAnotherWithOtherShadersFlagsOrSettings) {
  fs::create_directory(at("shaders"));
  write("shaders/a.glsl", "// one");
  const auto id = [&](Arguments more) {
    more.insert(more.end(), {"--list", "--json"});
    return json::parse(replay(more, no_device_).out)["plan"]["id"].get<std::string>();
  };
  std::set<std::string> ids{id({}), id({"--shaders", "shaders"}), id({"--seed", "9"}),
                            id({"--set", "sorted.order=cpu"})};
  write("shaders/a.glsl", "// two");
  ids.insert(id({"--shaders", "shaders"}));
  fs::rename(at("shaders/a.glsl"), at("shaders/b.glsl"));
  ids.insert(id({"--shaders", "shaders"}));
  EXPECT_EQ(ids.size(), 6u);
  EXPECT_TRUE(ids.contains(id({"--shaders", "shaders"})));
}

TEST_F(PlanTest, ResultsNameTheJobsOfTheList) {
  const json list = json::parse(replay({"--list", "--json"}).out);
  ASSERT_EQ(replay({}).exit_code, 0);
  const json all = results();
  EXPECT_EQ(all["plan"]["id"], list["plan"]["id"]);
  ASSERT_EQ(all["frames"].size(), 4u);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(all["frames"][i]["job"], list["jobs"][i]["job"]);
    EXPECT_EQ(all["plan"]["order"][i], list["jobs"][i]["job"]);
    EXPECT_EQ(all["frames"][i]["seed"], list["jobs"][i]["seed"]);
  }
  ASSERT_EQ(all["moments"].size(), 2u);
  EXPECT_EQ(all["moments"][1]["job"], "street_000060_sorted");
  EXPECT_EQ(all["moments"][1]["tick"], 60);
}

TEST_F(PlanTest, DrawsOneJobAlone) {
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  ASSERT_EQ(replay({"--only", "street_000060_wboit-weight-eq10"}).exit_code, 0);
  const json one = without_times(results()), whole = without_times(results("whole"));
  ASSERT_EQ(one["frames"].size(), 1u);
  EXPECT_EQ(one["frames"][0], whole["frames"][3]);
  EXPECT_EQ(one["moments"], json::array({whole["moments"][1]}));
  EXPECT_EQ(one["plan"], whole["plan"]);
  const auto drawn = pictures();
  ASSERT_EQ(drawn.size(), 2u);
  for (const auto& [name, bytes] : drawn) EXPECT_EQ(bytes, pictures("whole").at(name)) << name;
}

TEST_F(PlanTest, UnknownJobNamesTheNearest) {
  const Outcome outcome = replay({"--only", "street_000020_sortet"}, no_device_);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"--only street_000020_sortet", "did you mean `street_000020_sorted`?"}));
}

TEST_F(PlanTest, RowsAreDrawnAgainByTheCommandTheyCameFrom) {
  ASSERT_EQ(replay({"--set", "wboit.depth_scale=0.5", "--size", "32x18", "--out", "a", "--json"}).exit_code,
            0);
  EXPECT_EQ(results("a")["command"],
            "plume replay 'my script.toml' --size 32x18 --set wboit.depth_scale=0.5");
  ASSERT_EQ(run({"compare", "quads_mcguire", "--methods", "sorted,wboit", "--size", "16x9", "--frames", "1",
                 "--out", "b"})
                .exit_code,
            0);
  EXPECT_EQ(results("b")["command"],
            "plume compare quads_mcguire --methods sorted,wboit --frames 1 --size 16x9");
}

TEST_F(PlanTest, ShardsOfJobsShareATick) {
  write("my script.toml",
        street_script("[0, 1]",
                      "[[method]]\nid = 'sorted'\n[[method]]\nid = 'wboit'\n[[method]]\nid = 'mlab'\n"));
  const auto methods = [&](const char* shard) {
    json found = json::array();
    const Outcome outcome = replay({"--list", "--json", "--shard", shard, "--by", "job"}, no_device_);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json list = json::parse(outcome.out);
    for (const json& job : list["jobs"]) found.push_back(job["method"]);
    return found;
  };
  EXPECT_EQ(methods("0/2"), json::parse(R"(["sorted", "mlab", "wboit"])"));
  EXPECT_EQ(methods("1/2"), json::parse(R"(["wboit", "sorted", "mlab"])"));
}

TEST_F(PlanTest, AMarkedPixelLiesInEverySizeOfASweep) {
  write("my script.toml",
        "name = 'S'\n[[sweep]]\nscenes = 'street'\nsizes = [[32, 18], [16, 9]]\n[[sweep.method]]\nid = "
        "'sorted'\n[capture]\npixels = [[15, 8]]\n");
  EXPECT_EQ(replay({"--list"}, no_device_).exit_code, 0);
  const Outcome outside = replay({"--list", "--pixel", "16,8"}, no_device_);
  EXPECT_EQ(outside.exit_code, 2);
  EXPECT_TRUE(says(outside.err, {"pixel 16,8", "16x9 ends at 15,8"}));
  write("shots.toml",
        "name = 'S'\nscene = 'street'\nsize = [640, 360]\n[[shot]]\ntick = 1\nmethod = 1\n[[shot]]\ntick = "
        "1\nmethod "
        "= 1\nsize = [16, 9]\n[[method]]\nid = 'sorted'\n");
  const Outcome shot = run({"replay", "shots.toml", "--list", "--pixel", "16,8"}, no_device_);
  EXPECT_EQ(shot.exit_code, 2);
  EXPECT_TRUE(says(shot.err, {"pixel 16,8", "16x9 ends at 15,8"}));
}

TEST_F(PlanTest, ShardsOfARangeFollowEachOther) {
  write("my script.toml", street_script("{first = 1, last = 7}", "[[method]]\nid = 'sorted'\n"));
  const auto ticks = [&](const Arguments& more) {
    Arguments arguments{"--list", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    json found = json::array();
    const Outcome outcome = replay(arguments, no_device_);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const json list = json::parse(outcome.out);
    for (const json& job : list["jobs"]) found.push_back(job["tick"]);
    return found;
  };
  EXPECT_EQ(ticks({"--shard", "0/3", "--by", "range"}), json::parse("[1, 2]"));
  EXPECT_EQ(ticks({"--shard", "1/3", "--by", "range"}), json::parse("[3, 4]"));
  EXPECT_EQ(ticks({"--by", "range", "--shard", "2/3"}), json::parse("[5, 6, 7]"));
  EXPECT_EQ(ticks({"--shard", "2/3"}), json::parse("[3, 6]"));
  const Outcome wrong = replay({"--shard", "0/2", "--by", "halves"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_TRUE(says(wrong.err, {"--by halves", "expected turn, range or job"}));
}

}  // namespace
}  // namespace plume
