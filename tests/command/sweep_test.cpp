// [[sweep]] in a replay: every combination is a job of its own.
#include <set>

#include "tests/command/program.h"

namespace plume {
namespace {

using Names = std::vector<std::string>;

class SweepTest : public ProgramTest {
 protected:
  Names list(const std::string& sweep, const Arguments& more = {}) {
    write("sweep.toml", "name = 'S'\nsize = [16, 9]\nframes = 1\nwarmup = 0\n" + sweep);
    Arguments arguments{"replay", "sweep.toml", "--list", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = run(arguments, {{"VK_ICD_FILENAMES", "/nonexistent"}});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    Names ids;
    if (outcome.exit_code != 0) return ids;
    const json list = json::parse(outcome.out);
    for (const json& job : list["jobs"]) ids.push_back(job["job"]);
    return ids;
  }
};

TEST_F(SweepTest, SpansValuesOfParameters) {
  EXPECT_EQ(list("[[sweep]]\nscenes = 'three_cards'\nticks = [7]\n[[sweep.method]]\nid = 'sorted'\n"
                 "[[sweep.method]]\nid = 'wboit'\nweight = ['eq7', 'eq10']\ndepth_scale = [1, 0.5]\nsums = "
                 "'half'\n"),
            (Names{"three_cards_000007_sorted", "three_cards_000007_wboit-depth_scale-1-sums-half-weight-eq7",
                   "three_cards_000007_wboit-depth_scale-1-sums-half-weight-eq10",
                   "three_cards_000007_wboit-depth_scale-0.5-sums-half-weight-eq7",
                   "three_cards_000007_wboit-depth_scale-0.5-sums-half-weight-eq10"}));
}

TEST_F(SweepTest, TableTellsSizesAndSeedsApartWhereTheyDiffer) {
  const auto table = [&](const std::string& sweep) {
    write("sweep.toml",
          "name = 'S'\nsize = [16, 9]\nframes = 1\nwarmup = 0\n[[sweep]]\nscenes = 'three_cards'\n" + sweep +
              "[[sweep.method]]\nid = 'sorted'\n");
    return run({"replay", "sweep.toml"}).out;
  };
  EXPECT_TRUE(says(table("sizes = [[32, 18], [16, 9]]\nseeds = [1, 2]\n"),
                   {"three_cards 32x18 seed 1 ", "three_cards 16x9 seed 2 "}));
  EXPECT_EQ(table("seeds = [3]\n").find("seed"), std::string::npos);
}

TEST_F(SweepTest, SpansScenesTicksSizesAndSeeds) {
  const Names ids = list(
      "[[sweep]]\nscenes = ['three_cards', 'glass']\nticks = {first = 1, last = 3}\nsizes = [[32, 18], [32, "
      "9]]\n"
      "seeds = [1, 8]\n[[sweep.method]]\nid = 'sorted'\n");
  EXPECT_EQ(ids.size(), 24u);
  EXPECT_EQ(ids.front(), "three_cards_000001_sorted_32x18_seed1");
  EXPECT_EQ(ids[3], "three_cards_000001_sorted_32x18_seed8");
  EXPECT_EQ(ids.back(), "glass_000003_sorted_32x9_seed8");
  EXPECT_EQ(std::set(ids.begin(), ids.end()).size(), 24u);
}

TEST_F(SweepTest, WhatIsNotSpannedIsTheScenesOwn) {
  EXPECT_EQ(list("[[sweep]]\nscenes = ['street', 'grenade']\n[[sweep.method]]\nid = 'sorted'\n"),
            (Names{"street_000400_sorted", "grenade_000430_sorted"}));
}

TEST_F(SweepTest, SweepsOfOneFileStandOneAfterTheOther) {
  EXPECT_EQ(
      list("[[sweep]]\nscenes = 'glass'\nticks = [1]\n[[sweep.method]]\nid = 'wboit'\n"
           "[[sweep]]\nscenes = 'glass'\nticks = [1]\nsizes = [8, 8]\n[[sweep.method]]\nid = 'wboit'\n"),
      (Names{"glass_000001_wboit_16x9", "glass_000001_wboit_8x8"}));
}

TEST_F(SweepTest, OneJobTwiceIsRefusedAlsoWhenItsTickIsTheScenes) {
  write("sweep.toml",
        "name = 'S'\n[[sweep]]\nscenes = 'street'\n[[sweep.method]]\nid = 'wboit'\n"
        "[[sweep]]\nscenes = 'street'\nticks = [400]\n[[sweep.method]]\nid = 'wboit'\n");
  const Outcome outcome = run({"replay", "sweep.toml", "--list"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"street at tick 400 with wboit is asked for twice"}));
}

TEST_F(SweepTest, IsDrawnAsItIsListed) {
  const Names ids = list(
      "[capture]\nerror_maps = false\n[[sweep]]\nscenes = ['three_cards', 'glass']\nticks = [0, 5]\n"
      "sizes = [[16, 9], [32, 18]]\n[[sweep.method]]\nid = 'wboit'\nweight = ['eq7', 'eq10']\n");
  const Outcome outcome = run({"replay", "sweep.toml"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 16u);
  for (size_t i = 0; i < ids.size(); ++i) {
    EXPECT_EQ(all["frames"][i]["job"], ids[i]);
    EXPECT_EQ(all["frames"][i]["image"], ids[i] + ".png");
  }
  EXPECT_EQ(pictures().size(), 16u);
  EXPECT_EQ(all["moments"].size(), 8u);
}

}  // namespace
}  // namespace plume
