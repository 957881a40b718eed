// The window, opened for real on a display of its own that nobody sees (Xvfb).
#include <sys/prctl.h>

#include <optional>

#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"

namespace plume {
namespace {

/// An X server on a free display, for as long as this lives.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int number_pipe[2];
    if (pipe(number_pipe) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      const std::string number_to = std::to_string(number_pipe[1]);
      const int silence = open("/dev/null", O_WRONLY);
      dup2(silence, STDERR_FILENO);
      prctl(PR_SET_PDEATHSIG, SIGTERM);  // does not outlive a test that crashes
      execlp("Xvfb", "Xvfb", "-displayfd", number_to.c_str(), "-screen", "0", "1280x720x24", "-nolisten",
             "tcp", nullptr);
      _exit(127);
    }
    ::close(number_pipe[1]);
    char byte = 0;
    while (::read(number_pipe[0], &byte, 1) == 1 && byte != '\n')
      number_ += byte;  // nothing when it cannot start
    ::close(number_pipe[0]);
  }
  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }
  VirtualDisplay(const VirtualDisplay&) = delete;

  bool works() const { return !number_.empty(); }
  Environment environment() const { return {{"DISPLAY", ":" + number_}, {"WAYLAND_DISPLAY", ""}}; }

 private:
  pid_t server_ = -1;
  std::string number_;
};

const Environment kNoDisplay{{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}};

class OpenTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    without_display_ = run({"open"}, kNoDisplay);
    if (says(without_display_.err, {"this build has no window"}))
      GTEST_SKIP() << "configured with PLUME_WINDOW=OFF, so there is no window to open";
  }

  Outcome without_display_;
};

class WindowTest : public OpenTest {
 protected:
  void SetUp() override {
    OpenTest::SetUp();
    if (IsSkipped()) return;
    display_.emplace();
    if (!display_->works()) GTEST_SKIP() << "Xvfb does not start; install the package xvfb";
  }

  /// Closes by itself after a few frames; any validation message would be an exit code.
  Outcome open(Arguments arguments, Environment environment = {}) {
    arguments.insert(arguments.end(), {"--validate", "--frames", "3", "--screenshot", "window.png"});
    environment.merge(display_->environment());
    return run(arguments, environment);
  }

  std::optional<VirtualDisplay> display_;
};

using HeadlessBuildTest = ProgramTest;

TEST_F(HeadlessBuildTest, OpenNamesTheCommandsThatNeedNoWindow) {
  const Outcome outcome = run({"open"}, kNoDisplay);
  if (!says(outcome.err, {"this build has no window"})) GTEST_SKIP() << "this build has a window";
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"PLUME_WINDOW=OFF", "plume compare", "plume replay"}));
}

TEST_F(OpenTest, NoDisplayNamesTheCommandsThatNeedNone) {
  EXPECT_EQ(without_display_.exit_code, 3);
  EXPECT_EQ(without_display_.out, "");
  EXPECT_TRUE(says(without_display_.err, {"no window can be opened", "plume compare", "plume replay"}));
}

TEST_F(OpenTest, NoCommandAndTheNameOfASceneMeanOpen) {
  for (const Arguments& arguments :
       {Arguments{}, Arguments{"street"}, Arguments{"quads_mcguire", "--at", "0"}})
    EXPECT_EQ(run(arguments, kNoDisplay).err, without_display_.err);
}

TEST_F(OpenTest, UnknownSceneNamesTheNearestBeforeAnyWindowOpens) {
  const Outcome outcome = run({"open", "streat"}, kNoDisplay);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_TRUE(says(outcome.err, {"unknown scene `streat`", "did you mean `street`?"}));
}

TEST_F(WindowTest, OpensPlaysAndClosesWithoutValidationMessages) {
  const Outcome outcome = open({"open", "street"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  const DisplayImage picture = read_png(at("window.png"));
  const auto brightest =
      std::ranges::max(picture.pixels, {}, [](const auto& p) { return p[0] + p[1] + p[2]; });
  EXPECT_GT(brightest[0] + brightest[1] + brightest[2], 300);
}

TEST_F(WindowTest, ShowsWhatCompareDraws) {
  const Outcome outcome = open({"open", "street", "--at", "200"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const DisplayImage picture = read_png(at("window.png"));
  ASSERT_EQ(run({"compare", "street", "--at", "200", "--methods", "avboit", "--frames", "1", "--size",
                 size_text(picture.width, picture.height)})
                .exit_code,
            0);
  EXPECT_EQ(picture.pixels, read_png(at("out/street_000200_avboit.png")).pixels);
}

TEST_F(WindowTest, SeedChangesThePicture) {
  ASSERT_EQ(open({"open", "street", "--at", "200"}).exit_code, 0);
  const auto before = read_png(at("window.png")).pixels;
  ASSERT_EQ(open({"open", "street", "--at", "200", "--seed", "7"}).exit_code, 0);
  EXPECT_NE(read_png(at("window.png")).pixels, before);
}

TEST_F(WindowTest, LostDeviceNamesThePass) {
  const Outcome outcome = open({"open", "street"}, {{"PLUME_FAULT", "device_lost@draw"}});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(says(outcome.err, {"the device was lost", "'draw'"}));
}

}  // namespace
}  // namespace plume
