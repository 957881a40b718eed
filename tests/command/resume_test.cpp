// Long jobs: split over machines, stopped by hand, gone on with later. The frames are those of one
// undisturbed run.
#include "sandbox/measure/image_io.h"
#include "sandbox/runs/folder_lock.h"
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class ResumeTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    play("{first = 10, last = 40, step = 10}");
  }
  void play(const std::string& ticks,
            const std::string& methods = "[[method]]\nid = 'sorted'\n[[method]]\nid = 'wboit'\n") {
    write("script.toml", street_script(ticks, methods));
  }
  Outcome replay(const Arguments& more = {}, const Environment& environment = {}) {
    Arguments arguments{"replay", "script.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, environment);
  }
  json timeless_frames(const fs::path& folder = "out") { return without_times(frames(folder)); }
  /// Sends `signal` to a replay once it has finished a tick.
  Outcome stop_after_a_tick(int signal) {
    const pid_t program = start({"replay", "script.toml"});
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (read("stderr").find("[1/") == std::string::npos && std::chrono::steady_clock::now() < deadline)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    kill(program, signal);
    return wait(program);
  }
};

TEST_F(ResumeTest, ShardsTogetherGiveTheFramesOfTheWholeRun) {
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  ASSERT_EQ(replay({"--out", "even", "--shard", "0/2"}).exit_code, 0);
  ASSERT_EQ(replay({"--out", "odd", "--shard", "1/2"}).exit_code, 0);
  const json whole = timeless_frames("whole"), even = timeless_frames("even"), odd = timeless_frames("odd");
  ASSERT_EQ(whole.size(), 8u);
  EXPECT_EQ(even, json::array({whole[0], whole[1], whole[4], whole[5]}));
  EXPECT_EQ(odd, json::array({whole[2], whole[3], whole[6], whole[7]}));
  auto together = pictures("even");
  together.merge(pictures("odd"));
  EXPECT_EQ(together, pictures("whole"));
}

TEST_F(ResumeTest, ShardWithNothingToDoWritesEmptyResults) {
  const Outcome outcome = replay({"--shard", "4/5"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results()["frames"], json::array());
  EXPECT_TRUE(pictures().empty());
}

TEST_F(ResumeTest, AFolderThatAnotherRunWritesIntoIsRefused) {
  fs::create_directory(at("out"));
  {
    const FolderLock other(at("out"));
    const Outcome outcome = replay();
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.err,
              "plume: another run is writing into out: wait until it ends, or choose another --out\n");
    EXPECT_TRUE(files().empty());
    EXPECT_EQ(replay({"--isolate"}).exit_code, 2);
    ASSERT_EQ(replay({"--out", "part"}).exit_code, 0);
    EXPECT_EQ(run({"merge", "part", "--out", "out"}).exit_code, 2);
  }
  EXPECT_EQ(replay({"--isolate"}).exit_code, 0);
}

TEST_F(ResumeTest, NothingIsDrawnAgainWhenAllIsThere) {
  ASSERT_EQ(replay().exit_code, 0);
  const json before = results();
  const auto written = fs::last_write_time(at("out/street_000010_sorted.png"));
  // A pass that fails would be noticed.
  const Outcome outcome = replay({"--resume"}, {{"PLUME_FAULT", "device_lost@draw"}});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(results(), before);  // times and all
  EXPECT_EQ(fs::last_write_time(at("out/street_000010_sorted.png")), written);
}

TEST_F(ResumeTest, WithoutResumeAllIsDrawnAgain) {
  ASSERT_EQ(replay().exit_code, 0);
  EXPECT_EQ(replay({}, {{"PLUME_FAULT", "device_lost@draw"}}).exit_code, 4);
  EXPECT_EQ(results()["frames"], json::array());
}

TEST_F(ResumeTest, GapsAreFilledInTheOrderOfTheJobs) {
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  ASSERT_EQ(replay({"--only", "street_000040_wboit", "--only", "street_000020_sorted"}).exit_code, 0);
  const json kept = results()["frames"];
  ASSERT_EQ(kept.size(), 2u);
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(without_times(results()), without_times(results("whole")));
  EXPECT_EQ(pictures(), pictures("whole"));
  const json after = results()["frames"];
  EXPECT_EQ(after[2], kept[0]);  // with its old times
  EXPECT_EQ(after[7], kept[1]);
}

TEST_F(ResumeTest, WhatOneJobLeavesDependsOnNoOther) {
  // Methods whose memory grows with what they met, and effects whose ticks could be stepped.
  play("[40, 41, 400]", "[[method]]\nid = 'linked_list'\n[[method]]\nid = 'avboit'\n");
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  const json whole = results("whole");
  for (const json& frame : whole["frames"])
    ASSERT_EQ(replay({"--resume", "--only", frame["job"]}).exit_code, 0);
  EXPECT_EQ(without_times(results()), without_times(results("whole")));
  EXPECT_EQ(pictures(), pictures("whole"));
}

TEST_F(ResumeTest, AnotherPlanIsNotMixedIn) {
  ASSERT_EQ(replay().exit_code, 0);
  const json before = results();
  const auto refuses = [&](const Arguments& more) {
    Arguments arguments{"--resume"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = replay(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(says(outcome.err, {"out/results.json is of another plan", "8 jobs", "--resume", "--out"}));
  };
  refuses({"--size", "32x18"});
  refuses({"--seed", "7"});
  refuses({"--pixel", "3,3"});
  refuses({"--set", "wboit.weight=eq9"});
  play("{first = 10, last = 40, step = 10}", "[[method]]\nid = 'wboit'\n");
  refuses({});
  EXPECT_EQ(results(), before);
}

TEST_F(ResumeTest, EditedPresetMakesAnotherPlan) {
  fs::create_directories(at("script"));
  for (const char* kind : {"scenes", "effects", "meshes"})
    fs::copy(fs::path(PLUME_SOURCE_PRESETS) / kind, at("script") / kind, fs::copy_options::recursive);
  const auto plan = [&] { return json::parse(replay({"--list", "--json"}).out)["plan"]["id"]; };
  const json before = plan();
  EXPECT_EQ(plan(), before);
  write("script/effects/sparks.toml", read("script/effects/sparks.toml") + "# not in the street\n");
  EXPECT_EQ(plan(), before);
  write("script/effects/fireball.toml", read("script/effects/fireball.toml") + "# brighter\n");
  const json effect = plan();
  EXPECT_NE(effect, before);
  write("script/scenes/street.toml", read("script/scenes/street.toml") + "# darker\n");
  EXPECT_NE(plan(), effect);
}

TEST_F(ResumeTest, HalfFilesOfAKilledProcessAreRemoved) {
  play("[20]");
  const pid_t dead = start({"replay", "script.toml"});
  ASSERT_EQ(wait(dead).exit_code, 0);
  const auto before = files();
  write("out/a.png.tmp-" + std::to_string(dead) + "-3", "half");
  write("out/b.png.tmp-" + std::to_string(getpid()) + "-3", "somebody is at it");
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  auto after = before;
  after.insert(after.begin(), "b.png.tmp-" + std::to_string(getpid()) + "-3");
  EXPECT_EQ(files(), after);
}

TEST_F(ResumeTest, RemovedPictureIsDrawnAgain) {
  ASSERT_EQ(replay().exit_code, 0);
  const json before = timeless_frames();
  const auto drawn = pictures();
  fs::remove(at("out/street_000020_wboit.png"));
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(pictures(), drawn);
  EXPECT_EQ(timeless_frames(), before);
}

TEST_F(ResumeTest, RemovedExrIsDrawnAgain) {
  play("[20]", "[capture]\nimages = false\nerror_maps = false\nhdr = true\n[[method]]\nid = 'wboit'\n");
  ASSERT_EQ(replay().exit_code, 0);
  const json before = timeless_frames();
  const auto drawn = pictures();
  fs::remove(at("out/street_000020_wboit.exr"));
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(pictures(), drawn);
  EXPECT_EQ(timeless_frames(), before);
}

TEST_F(ResumeTest, InterruptedRunIsCompletedByResume) {
  play("{first = 0, last = 79}", "[capture]\nerror_maps = false\n[[method]]\nid = 'sorted'\n");
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  const Outcome outcome = stop_after_a_tick(SIGINT);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_TRUE(says(outcome.err, {"interrupted", "--resume"}));
  EXPECT_EQ(outcome.out, "");

  const json partial = results();
  ASSERT_GT(partial["frames"].size(), 0u);
  ASSERT_LT(partial["frames"].size(), 80u);
  EXPECT_EQ(partial["moments"].size(), partial["frames"].size());
  EXPECT_EQ(files().size(), partial["frames"].size() + 2);  // a picture each, results.json and results.csv
  for (const json& frame : partial["frames"])
    EXPECT_TRUE(fs::exists(at("out") / frame["image"].get<std::string>()));

  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(timeless_frames(), timeless_frames("whole"));
  EXPECT_EQ(pictures(), pictures("whole"));
  EXPECT_EQ(results()["frames"][0], partial["frames"][0]);  // with its old times
}

TEST_F(ResumeTest, KilledRunIsCompletedByResume) {
  play("{first = 0, last = 79}", "[capture]\nerror_maps = false\n[[method]]\nid = 'sorted'\n");
  ASSERT_EQ(stop_after_a_tick(SIGKILL).exit_code, 128 + SIGKILL);
  const json partial = results();
  ASSERT_GT(partial["frames"].size(), 0u);
  ASSERT_LT(partial["frames"].size(), 80u);
  for (const auto& [name, bytes] : pictures()) EXPECT_NO_THROW(read_png(at("out") / name)) << name;
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(results()["frames"].size(), 80u);
  EXPECT_EQ(results()["frames"][0], partial["frames"][0]);
}

TEST_F(ResumeTest, ResultsOfAnotherDeviceAreNotMixedIn) {
  ASSERT_EQ(replay().exit_code, 0);
  json other = results();
  other["environment"]["device"] = "another";
  write("out/results.json", other.dump());
  const Outcome outcome = replay({"--resume"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"out/results.json", "device \"another\"", "--resume", "--out"}));
  EXPECT_EQ(results(), other);
}

TEST_F(ResumeTest, BrokenResultsAreNamed) {
  for (const char* broken :
       {"{", "{}", "[]", "{\"environment\": {}, \"demand\": null, \"frames\": [{\"tick\": 1}]}"}) {
    write("out/results.json", broken);
    const Outcome outcome = replay({"--resume"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(says(outcome.err, {"out/results.json is not a results.json"}));
    EXPECT_EQ(read("out/results.json"), broken);
  }
}

}  // namespace
}  // namespace plume
