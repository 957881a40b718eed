// Long jobs: split over machines, stopped by hand, gone on with later. The frames are those of one
// undisturbed run.
#include "sandbox/measure/image_io.h"
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
  /// Frames without their times, which no two runs share.
  json frames(const fs::path& folder = "out") {
    json frames = results(folder)["frames"];
    for (json& frame : frames) {
      frame.erase("gpu_ms");
      frame.erase("transparency_ms");
      for (json& pass : frame["passes"]) pass = pass["name"];
    }
    return frames;
  }
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
  const json whole = frames("whole"), even = frames("even"), odd = frames("odd");
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
  play("[20, 40]");
  ASSERT_EQ(replay().exit_code, 0);
  const json kept = results()["frames"];
  play("{first = 10, last = 40, step = 10}");
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  ASSERT_EQ(frames(), frames("whole"));
  EXPECT_EQ(pictures(), pictures("whole"));
  const json after = results()["frames"];
  EXPECT_EQ(after[2], kept[0]);  // with its old times
  EXPECT_EQ(after[7], kept[3]);
}

TEST_F(ResumeTest, AddedMethodStandsInTheOrderOfTheJobs) {
  ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
  play("{first = 10, last = 40, step = 10}", "[[method]]\nid = 'wboit'\n");
  ASSERT_EQ(replay().exit_code, 0);
  const json kept = results()["frames"];
  play("{first = 10, last = 40, step = 10}");
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  ASSERT_EQ(frames(), frames("whole"));
  EXPECT_EQ(results()["frames"][3], kept[1]);
}

TEST_F(ResumeTest, RemovedPictureIsDrawnAgain) {
  ASSERT_EQ(replay().exit_code, 0);
  const json before = frames();
  const auto drawn = pictures();
  fs::remove(at("out/street_000020_wboit.png"));
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(pictures(), drawn);
  EXPECT_EQ(frames(), before);
}

TEST_F(ResumeTest, RemovedExrIsDrawnAgain) {
  play("[20]", "[capture]\nimages = false\nerror_maps = false\nhdr = true\n[[method]]\nid = 'wboit'\n");
  ASSERT_EQ(replay().exit_code, 0);
  const json before = frames();
  const auto drawn = pictures();
  fs::remove(at("out/street_000020_wboit.exr"));
  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(pictures(), drawn);
  EXPECT_EQ(frames(), before);
}

TEST_F(ResumeTest, FramesOfAnotherSizeGoWithTheirOverwrittenPictures) {
  ASSERT_EQ(replay().exit_code, 0);
  ASSERT_EQ(replay({"--resume", "--size", "32x18"}).exit_code, 0);
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 8u);
  for (const json& frame : all["frames"]) EXPECT_EQ(frame["size"], json::parse("[32, 18]"));
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
  EXPECT_TRUE(partial["demand"].is_object());
  EXPECT_EQ(files().size(), partial["frames"].size() + 2);  // a picture each, results.json and results.csv
  for (const json& frame : partial["frames"])
    EXPECT_TRUE(fs::exists(at("out") / frame["image"].get<std::string>()));

  ASSERT_EQ(replay({"--resume"}).exit_code, 0);
  EXPECT_EQ(frames(), frames("whole"));
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
