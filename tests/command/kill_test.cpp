// kill -9 at any moment costs nothing but the frame that was being drawn; no more does Ctrl+C, once or twice.
#include <random>

#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

class KillTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("script.toml",
          "name = 'R'\nscene = 'three_cards'\nsize = [64, 36]\nframes = 1\nwarmup = 0\nticks = {first = 0, "
          "last = "
          "59}\n[capture]\nhdr = true\n[[method]]\nid = 'sorted'\n[[method]]\nid = 'wboit'\n");
    const auto before = std::chrono::steady_clock::now();
    ASSERT_EQ(run({"replay", "script.toml", "--out", "whole"}).exit_code, 0);
    whole_ = std::chrono::steady_clock::now() - before;
  }

  static int times() { return every(10) == 1 ? 200 : 10; }
  void wait_a_share_of_the_whole(double share) const { std::this_thread::sleep_for(share * whole_); }
  /// Goes on to the end, which is that of the run that nothing disturbed; then all is gone.
  void finish() {
    const Outcome last = run({"replay", "script.toml", "--resume"});
    ASSERT_EQ(last.exit_code, 0) << last.err;
    EXPECT_EQ(without_times(results()), without_times(results("whole")));
    EXPECT_EQ(files(), files("whole"));  // no half of a file either
    for (const std::string& file : files())
      if (file.ends_with(".png") || file.ends_with(".exr")) {
        EXPECT_EQ(read("out/" + file), read("whole/" + file)) << file;
      }
    fs::remove_all(at("out"));
  }

 private:
  std::chrono::duration<double> whole_{};
};

TEST_F(KillTest, TenTimesAtRandomLeaveTheSameBytes) {
  std::mt19937 random(7);
  int killed = 0;
  for (int i = 0; i < times(); ++i) {
    if (i % 10 == 9) finish();  // or there is nothing left to be killed in
    const pid_t program = start({"replay", "script.toml", "--resume"});
    wait_a_share_of_the_whole(std::uniform_real_distribution<double>(0, 0.25)(random));
    kill(program, SIGKILL);
    killed += wait(program).exit_code == 128 + SIGKILL;
  }
  EXPECT_GE(killed, times() / 2);  // or the test kills what is over
  finish();
}

TEST_F(KillTest, InterruptionsAtAnyMomentLeaveTheSameBytes) {
  std::mt19937 random(11);
  int interrupted = 0;
  for (int i = 0; i < times(); ++i) {
    if (i % 10 == 9) finish();
    const bool twice = i % 2 == 1;
    const pid_t program = start({"replay", "script.toml", "--resume"});
    wait_a_share_of_the_whole(std::uniform_real_distribution<double>(0, 0.3)(random));
    kill(program, SIGINT);
    if (twice) kill(program, SIGINT);
    const Outcome outcome = wait(program);
    if (outcome.exit_code == 0) continue;
    EXPECT_EQ(outcome.exit_code, 130);  // so a shell says of who was killed by it, too
    EXPECT_EQ(outcome.out, "");
    if (fs::exists(at("out/results.json"))) {
      EXPECT_NO_THROW(results());
    }
    ++interrupted;
  }
  EXPECT_GE(interrupted, times() / 2);
  finish();
}

}  // namespace
}  // namespace plume
