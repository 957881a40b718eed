// kill -9 at any moment costs nothing but the frame that was being drawn.
#include <random>

#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"

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
  }
};

TEST_F(KillTest, TenTimesAtRandomLeaveTheSameBytes) {
  const auto before = std::chrono::steady_clock::now();
  ASSERT_EQ(run({"replay", "script.toml", "--out", "whole"}).exit_code, 0);
  const double whole_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - before).count();
  std::mt19937 random(7);
  int killed = 0;
  for (int i = 0; i < 10; ++i) {
    const pid_t program = start({"replay", "script.toml", "--resume"});
    const double ms = whole_ms * std::uniform_real_distribution<double>(0, 0.25)(random);
    std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(ms));
    kill(program, SIGKILL);
    killed += wait(program).exit_code == 128 + SIGKILL;
  }
  EXPECT_GE(killed, 5);  // or the test kills what is over
  const Outcome last = run({"replay", "script.toml", "--resume"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(without_times(results()), without_times(results("whole")));
  EXPECT_EQ(files(), files("whole"));  // no half of a file either
  for (const std::string& file : files())
    if (file.ends_with(".png") || file.ends_with(".exr")) {
      EXPECT_EQ(read("out/" + file), read("whole/" + file)) << file;
    }
}

}  // namespace
}  // namespace plume
