// plume … --isolate: what one job breaks, no other notices.
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

namespace plume {
namespace {

class IsolateTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("my script.toml",
          street_script("[20]",
                        "[[method]]\nid = 'sorted'\n[[method]]\nid = 'avboit'\n[[method]]\nid = 'wboit'\n"));
  }
  Outcome replay(const Arguments& more, const Environment& environment = {}) {
    Arguments arguments{"replay", "my script.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments, environment);
  }
  void expect_as_drawn_in_one_process() {
    ASSERT_EQ(replay({"--out", "whole"}).exit_code, 0);
    EXPECT_EQ(without_times(results()), without_times(results("whole")));
    EXPECT_EQ(files(), files("whole"));
    EXPECT_EQ(pictures(), pictures("whole"));
  }
};

TEST_F(IsolateTest, LeavesWhatOneProcessLeaves) {
  const Outcome outcome = replay({"--isolate"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.err, {"[1/3] street_000020_sorted", "[3/3] street_000020_wboit"}));
  EXPECT_TRUE(says(outcome.out, {"report: out/report.html"}));
  expect_as_drawn_in_one_process();
}

TEST_F(IsolateTest, LostDeviceCostsOneJobWhichIsTriedTwice) {
  const Outcome outcome = replay({"--isolate"}, {{"PLUME_FAULT", "device_lost@integrate"}});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(says(outcome.err, {"street_000020_avboit: exit 4: the device was lost", "trying once more",
                                 "1 of 3 jobs failed", "--resume"}));
  const json all = results();
  ASSERT_EQ(all["frames"].size(), 3u);
  EXPECT_EQ(all["frames"][0]["status"], "ok");
  EXPECT_TRUE(says(all["frames"][1]["status"], {"failed: exit 4: the device was lost", "'integrate'"}));
  EXPECT_EQ(all["frames"][2]["status"], "ok");
  EXPECT_EQ(pictures().size(), 4u);
  EXPECT_TRUE(fs::exists(at("out/report.html")));

  ASSERT_EQ(replay({"--isolate", "--resume"}).exit_code, 0);
  EXPECT_EQ(results()["frames"][0], all["frames"][0]);  // with its old times
  expect_as_drawn_in_one_process();
}

TEST_F(IsolateTest, JobThatFailedIsTriedOnceMore) {
  const Outcome outcome =
      replay({"--isolate", "--only", "street_000020_avboit"},
             {{"PLUME_FAULT", "crash@integrate"}, {"PLUME_FAULT_ONCE", at("once").string()}});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(outcome.err, {"street_000020_avboit: signal 6", "trying once more", "[1/1]"}));
  EXPECT_EQ(results()["frames"][0]["status"], "ok");
}

TEST_F(IsolateTest, CrashCostsOneJob) {
  const Outcome outcome = replay({"--isolate"}, {{"PLUME_FAULT", "crash@integrate"}});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(says(results()["frames"][1]["status"], {"failed: signal 6"}));
  EXPECT_EQ(pictures().size(), 4u);
}

TEST_F(IsolateTest, MissingDeviceEndsTheRun) {
  const Outcome outcome = replay({"--isolate"}, {{"VK_ICD_FILENAMES", "/nonexistent"}});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_TRUE(says(outcome.err, {"install a driver"}));
}

TEST_F(IsolateTest, InterruptionStopsTheJobToo) {
  write("my script.toml", street_script("{first = 0, last = 200}", "[[method]]\nid = 'sorted'\n"));
  const pid_t program = start({"replay", "my script.toml", "--isolate"});
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (read("stderr").find("[1/") == std::string::npos && std::chrono::steady_clock::now() < deadline)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(program, SIGINT);
  const Outcome outcome = wait(program);
  EXPECT_EQ(outcome.exit_code, 130);
  EXPECT_TRUE(says(outcome.err, {"interrupted", "--resume"}));
  EXPECT_GE(results()["frames"].size(), 1u);
  EXPECT_FALSE(fs::exists(at("out/.jobs")));
}

// As a terminal does: the job is told by it and by the program.
TEST_F(IsolateTest, CtrlCIsNoFailureOfTheJob) {
  write("my script.toml", street_script("{first = 0, last = 200}", "[[method]]\nid = 'sorted'\n"));
  for (const int ms : {10, 60, 110, 160, 210}) {
    const pid_t program = start({"replay", "my script.toml", "--isolate", "--resume"});
    const std::string id = std::to_string(program), children = "/proc/" + id + "/task/" + id + "/children";
    pid_t job = 0;
    for (int i = 0; job == 0 && i < 20'000; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(1)))
      std::ifstream(children) >> job;
    ASSERT_NE(job, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
    kill(job, SIGINT);
    kill(program, SIGINT);
    kill(job, SIGINT);
    const Outcome outcome = wait(program);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_FALSE(says(outcome.err, {"trying once more"})) << outcome.err;
    for (const json& frame : frames()) EXPECT_EQ(frame["status"], "ok");
  }
}

}  // namespace
}  // namespace plume
