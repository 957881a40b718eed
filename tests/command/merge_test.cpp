// plume merge: shards put together are what one machine would have left.
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class MergeTest : public ProgramTest {
 protected:
  void play(const std::string& ticks) {
    write("script.toml",
          "name = 'R'\nscene = 'three_cards'\nsize = [32, 18]\nframes = 1\nwarmup = 0\nticks = " + ticks +
              "\n[[method]]\nid = 'sorted'\n[[method]]\nid = 'wboit'\n");
  }
  Outcome replay(const Arguments& more) {
    Arguments arguments{"replay", "script.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  /// Two shards of four jobs.
  void draw_halves() {
    play("[0, 1]");
    ASSERT_EQ(replay({"--out", "a", "--shard", "0/2"}).exit_code, 0);
    ASSERT_EQ(replay({"--out", "b", "--shard", "1/2"}).exit_code, 0);
  }
  void expect_refusal(const Arguments& arguments, const std::vector<std::string>& parts) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(says(outcome.err, parts));
    EXPECT_FALSE(fs::exists(at("all")));
  }
  void change(const fs::path& folder, const std::function<void(json&)>& edit) {
    json all = results(folder);
    edit(all);
    write(folder / "results.json", all.dump(2) + "\n");
  }
};

TEST_F(MergeTest, FourHundredJobsOnTwoShardsAreThoseOfOneRun) {
  play("{first = 0, last = 199}");
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  ASSERT_EQ(replay({"--out", "a", "--shard", "0/2", "--by", "range"}).exit_code, 0);
  ASSERT_EQ(replay({"--out", "b", "--shard", "1/2", "--by", "range"}).exit_code, 0);
  const Outcome outcome = run({"merge", "b", "a", "--out", "all"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.out, {"report: all/report.html"}));
  const json all = results("all");
  EXPECT_EQ(all["frames"].size(), 400u);
  EXPECT_EQ(without_times(all), without_times(results("whole")));
  EXPECT_EQ(files("all"), files("whole"));
  EXPECT_EQ(pictures("all"), pictures("whole"));
  EXPECT_EQ(all["frames"][0], results("a")["frames"][0]);  // with the times of who drew it
  // What is dealt one by one, and put together again, is the same.
  ASSERT_EQ(run({"merge", "all", "--out", "again"}).exit_code, 0);
  EXPECT_EQ(read("again/results.json"), read("all/results.json"));
  EXPECT_EQ(read("again/results.csv"), read("all/results.csv"));
  EXPECT_EQ(read("again/report.html"), read("all/report.html"));
}

TEST_F(MergeTest, MissingJobsAreNamed) {
  draw_halves();
  expect_refusal({"merge", "a", "--out", "all"},
                 {"2 of 4 jobs", "three_cards_000001_sorted, three_cards_000001_wboit", "--resume"});
}

TEST_F(MergeTest, FailedJobsAreMissing) {
  draw_halves();
  change("b", [](json& all) { all["frames"][1]["status"] = "failed: exit 4"; });
  expect_refusal({"merge", "a", "b", "--out", "all"}, {"1 of 4 jobs", "three_cards_000001_wboit"});
}

TEST_F(MergeTest, PartsOfOtherPlansAreRefused) {
  draw_halves();
  play("[0, 2]");
  ASSERT_EQ(replay({"--out", "c", "--shard", "1/2"}).exit_code, 0);
  expect_refusal({"merge", "a", "c", "--out", "all"},
                 {"a/results.json", "c/results.json", "parts of one plan"});
}

TEST_F(MergeTest, PartsOfOtherDevicesAreRefused) {
  draw_halves();
  change("b", [](json& all) { all["environment"]["driver"] = "another"; });
  expect_refusal({"merge", "a", "b", "--out", "all"},
                 {"b/results.json", "driver", "\"another\"", "side by side"});
}

TEST_F(MergeTest, WhatTwoPartsHaveMustAgree) {
  draw_halves();
  fs::copy(at("b"), at("c"));
  ASSERT_EQ(run({"merge", "a", "b", "c", "--out", "twice"}).exit_code, 0);
  change("c", [](json& all) { all["frames"][0]["gpu_ms"] = 1e9; });
  ASSERT_EQ(run({"merge", "a", "b", "c", "--out", "times"}).exit_code, 0);
  write("c/three_cards_000001_sorted.png", "another");
  expect_refusal({"merge", "a", "b", "c", "--out", "all"},
                 {"b and c both have three_cards_000001_sorted", "three_cards_000001_sorted.png"});
  change("c", [](json& all) { all["frames"][1]["memory_bytes"] = 1; });
  fs::copy_file(at("b/three_cards_000001_sorted.png"), at("c/three_cards_000001_sorted.png"),
                fs::copy_options::overwrite_existing);
  expect_refusal({"merge", "a", "b", "c", "--out", "all"},
                 {"three_cards_000001_wboit", "not the same results"});
}

TEST_F(MergeTest, PartIsNotOverwritten) {
  draw_halves();
  const std::string before = read("a/results.json");
  const Outcome outcome = run({"merge", "a", "b", "--out", "./a"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"--out ./a is one of the parts"}));
  EXPECT_EQ(read("a/results.json"), before);
}

TEST_F(MergeTest, FolderWithoutResultsIsNamed) {
  draw_halves();
  fs::create_directory(at("empty"));
  expect_refusal({"merge", "a", "empty", "--out", "all"}, {"empty/results.json", "No such file"});
}

}  // namespace
}  // namespace plume
