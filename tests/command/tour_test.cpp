// The walk through the real window that scripts/tour.sh takes, in its short form: start, scrub, methods,
// crosshair, colours, views, an effect edited, broken and mended, a recording that is replayed to the same
// pictures, resizes, the end without a message.
#include "tests/command/program.h"

namespace plume {
namespace {

class WindowTourTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    for (const char* tool : {"Xvfb", "xdotool", "convert"})
      if (std::system((std::string("command -v ") + tool + " >/dev/null").c_str()) != 0)
        GTEST_SKIP() << "there is no " << tool << "; install the packages xvfb, xdotool, imagemagick";
    if (says(run({"open"}, {{"DISPLAY", ""}, {"WAYLAND_DISPLAY", ""}}).err, {"this build has no window"}))
      GTEST_SKIP() << "configured with PLUME_WINDOW=OFF, so there is no window to open";
  }
};

TEST_F(WindowTourTest, FindsEverythingAsItShouldBe) {
  const std::string command = std::string("'" PLUME_SOURCE_TESTS "/../scripts/tour.sh' --short --program '") +
                              PLUME_PROGRAM + "' --out '" + at("tour").string() + "' 2>'" +
                              at("said").string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << read("said");
  EXPECT_TRUE(says(read("said"), {"are the same to the bit", "no message, no leak, exit code 0"}));
}

}  // namespace
}  // namespace plume
