// The window, opened for real on a display of its own that nobody sees (Xvfb).
#include <cmath>
#include <optional>

#include "sandbox/measure/image_io.h"
#include "tests/command/program.h"
#include "tests/command/virtual_display.h"

namespace plume {
namespace {

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

TEST_F(WindowTest, ShowsTheViewsThatInspectWrites) {
  for (const char* view : {"culling_depth", "flip"}) {
    const Outcome outcome = open({"open", "street", "--at", "200", "--view", view});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const DisplayImage picture = read_png(at("window.png"));
    ASSERT_EQ(run({"inspect", "street", "--at", "200", "--view", view, "--out", "view.png", "--size",
                   size_text(picture.width, picture.height)})
                  .exit_code,
              0);
    EXPECT_EQ(picture.pixels, read_png(at("view.png")).pixels) << view;
  }
}

TEST_F(WindowTest, SeedChangesThePicture) {
  ASSERT_EQ(open({"open", "street", "--at", "200"}).exit_code, 0);
  const auto before = read_png(at("window.png")).pixels;
  ASSERT_EQ(open({"open", "street", "--at", "200", "--seed", "7"}).exit_code, 0);
  EXPECT_NE(read_png(at("window.png")).pixels, before);
}

// Both tell the picture's size and the pixel, so that the other can be asked for the same.
Arguments probe_of(const json& dumped, const std::string& methods) {
  const auto number = [&](const char* key, size_t i) {
    return std::to_string(dumped.at(key).at(i).get<uint32_t>());
  };
  return {"probe",     dumped.at("scene").get<std::string>(),
          "--at",      std::to_string(dumped.at("tick").get<uint32_t>()),
          "--size",    number("size", 0) + "x" + number("size", 1),
          "--pixel",   number("pixel", 0) + "," + number("pixel", 1),
          "--methods", methods};
}

TEST_F(WindowTest, CrosshairShowsWhatProbePrints) {
  const Outcome outcome =
      run({"open", "three_cards", "--at", "0", "--validate", "--frames", "25", "--crosshair", "0.05,-0.03",
           "--crosshair-methods", "moments", "--dump", "crosshair.json"},
          display_->environment());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json shown = json::parse(read("crosshair.json"));
  ASSERT_EQ(shown.at("methods").size(), 2u);
  ASSERT_GT(shown.at("fragments").size(), 12u);
  const Outcome probed = run(probe_of(shown, "avboit,moments"));
  ASSERT_EQ(probed.exit_code, 0) << probed.err;
  EXPECT_EQ(json::parse(probed.out), shown);
}

TEST_F(WindowTest, AClickPlacesTheCrosshairAndArrowsMoveIt) {
  if (std::system("command -v xdotool > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "nothing to click with; install the package xdotool";
  const pid_t window = start({"open", "three_cards", "--at", "0", "--validate", "--frames", "80",
                              "--crosshair", "0,0", "--dump", "crosshair.json"},
                             display_->environment());
  std::string keys;
  for (int i = 0; i < 20; ++i) keys += " Right";
  for (int i = 0; i < 10; ++i) keys += " Down";
  const std::string user = "DISPLAY=" + display_->environment().at("DISPLAY") +
                           " timeout 20 xdotool search --sync --onlyvisible --name Plume mousemove 600 150 "
                           "key r click 1 sleep 1 key" +
                           keys + " > /dev/null";
  EXPECT_EQ(std::system(user.c_str()), 0);
  const Outcome outcome = wait(window);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json shown = json::parse(read("crosshair.json"));
  const double width = shown["size"][0], height = shown["size"][1];
  // Where it was clicked, in heights of the picture, which fills what the panels leave of the window.
  constexpr double kLeft = 24 * 13, kRight = 1280 - 24 * 13, kBottom = 720 - (4.6 + 19) * 13;
  const double x = (600 - 0.5 * (kLeft + kRight)) / kBottom, y = (150 - 0.5 * kBottom) / kBottom;
  EXPECT_NEAR(shown["pixel"][0].get<double>(), std::floor(x * height + 0.5 * width) + 20, 1);
  EXPECT_NEAR(shown["pixel"][1].get<double>(), std::floor(y * height + 0.5 * height) + 10, 1);
  EXPECT_FALSE(shown["fragments"].empty());
}

TEST_F(WindowTest, KeepsItsSettingsForTheNextSession) {
  ASSERT_EQ(open({"open", "glass"}).exit_code, 0);
  const std::string settings = read("config/settings.toml");
  EXPECT_TRUE(says(settings, {"scene = \"glass\"", "size = [1280, 720]", "method = \"avboit\""}));
  write("config/settings.toml",
        "scene = 'quads_mcguire'\n[window]\nsize = [900, 500]\npanels = false\n[a]\nmethod = 'wboit'\n");
  ASSERT_EQ(open({"open", "--at", "0"}).exit_code, 0);
  EXPECT_TRUE(says(read("config/settings.toml"), {"recent_scenes = [\"quads_mcguire\"]", "size = [900, 500]",
                                                  "panels = false", "method = \"wboit\""}));
  const DisplayImage picture = read_png(at("window.png"));
  EXPECT_EQ(picture.width, 450);  // half of the window, which has no panels
  EXPECT_EQ(picture.height, 250);
}

TEST_F(WindowTest, KeepsWhatWasChangedByHand) {
  if (std::system("command -v xdotool > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "nothing to press keys with; install the package xdotool";
  const pid_t window = start({"open", "quads_mcguire", "--at", "0"}, display_->environment());
  const std::string user = "DISPLAY=" + display_->environment().at("DISPLAY") +
                           " timeout 20 xdotool search --sync --onlyvisible --name Plume mousemove 600 150 "
                           "sleep 2 key Tab sleep 0.5 key ctrl+equal sleep 0.5 key Escape > /dev/null";
  EXPECT_EQ(std::system(user.c_str()), 0);
  EXPECT_EQ(wait(window).exit_code, 0);
  EXPECT_TRUE(says(read("config/settings.toml"), {"panels = false", "text_scale = 1.125"}));
}

TEST_F(WindowTest, PutsBrokenSettingsAsideAndTellsWhatIsLeftOut) {
  write("config/settings.toml", "scene = 3\n");
  Outcome outcome = open({"open", "quads_mcguire"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(says(outcome.err, {"settings.toml:1:9", "settings.toml.broken"}));
  EXPECT_EQ(read("config/settings.toml.broken"), "scene = 3\n");
  write("config/settings.toml", "scene = 'gone'\n[a]\nmethod = 'gone as well'\n");
  outcome = open({"open"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(says(outcome.err, {"gone is no longer there to open", "no method `gone as well`"}));
  EXPECT_TRUE(says(read("config/settings.toml"), {"scene = \"street\""}));
}

TEST_F(WindowTest, LargerTextLeavesLessToThePicture) {
  const auto width = [&](const char* scale) {
    write("config/settings.toml", std::string("[window]\ntext_scale = ") + scale + "\n");
    EXPECT_EQ(open({"open", "quads_mcguire", "--at", "0"}).exit_code, 0);
    return read_png(at("window.png")).width;
  };
  // The panels are 48 lines of text wide.
  EXPECT_EQ(width("1.0"), (1280 - 48 * 13) / 2);
  EXPECT_EQ(width("1.5"), (1280 - 48 * 20) / 2);
}

TEST_F(OpenTest, FailedStartWritesNothing) {
  write("config/settings.toml", "scene = 3\n");
  run({"open"}, kNoDisplay);
  EXPECT_EQ(files("config"), (std::vector<std::string>{"settings.toml"}));
  EXPECT_FALSE(fs::exists(at("cache")));
}

/// Shaders in a folder, which somebody edits while a window shows what they draw.
class ShaderEditTest : public WindowTest {
 protected:
  void SetUp() override {
    WindowTest::SetUp();
    if (IsSkipped()) return;
    fs::copy(PLUME_SOURCE_SHADERS, at("shaders"), fs::copy_options::recursive);
    good_ = read(kShader);
    const size_t at = good_.find("imageStore(");
    ASSERT_NE(at, good_.npos);
    const auto line = 1 + std::count(good_.begin(), good_.begin() + std::ptrdiff_t(at), '\n');
    place_ = "post/display.comp:" + std::to_string(line) + ":";
    broken_ = good_;
    broken_.insert(at + 7, "r");
    red_ = good_;  // so that a picture tells which shaders drew it
    const std::string_view result = "vec4(srgb(clamp(color, 0.0, 1.0)), 1.0)";
    ASSERT_NE(red_.find(result), red_.npos);
    red_.replace(red_.find(result), result.size(), "vec4(1.0, 0.0, 0.0, 1.0)");
  }
  void open_window() {
    Environment environment = display_->environment();
    environment["PLUME_WIDGET_PLACES"] = at("places").string();
    window_ = start({"open", "quads_mcguire", "--at", "0", "--validate", "--shaders", "shaders",
                     "--crosshair", "0,0", "--frames", "100000", "--screenshot", "window.png"},
                    environment);
  }
  bool comes_to_show(const std::string& words, bool shown = true) const {
    for (int i = 0; i < 1500; ++i, std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (fs::exists(at("places")) && (read("places").find(words) != std::string::npos) == shown) return true;
    return false;
  }
  /// By Ctrl+C, with time for a picture before that.
  void expect_red_once_it_is_closed() {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    kill(window_, SIGINT);
    const Outcome outcome = wait(window_);
    EXPECT_EQ(outcome.exit_code, 130);
    EXPECT_EQ(outcome.err, "plume: interrupted; settings and what was recorded are kept\n");
    EXPECT_EQ(read_png(at("window.png")).pixels.front(), (std::array<uint8_t, 3>{255, 0, 0}));
  }

  const fs::path kShader = "shaders/post/display.comp";
  std::string good_, broken_, red_, place_;
  pid_t window_ = -1;
};

TEST_F(ShaderEditTest, BrokenOnesAreNamedAndTheOldOnesGoOn) {
  open_window();
  EXPECT_TRUE(comes_to_show("picture = 1"));
  write(kShader, broken_);
  EXPECT_TRUE(comes_to_show("problem = "));
  EXPECT_TRUE(says(read("places"), {place_, "imageStrore"}));
  write(kShader, red_);
  EXPECT_TRUE(comes_to_show("problem = ", false));
  expect_red_once_it_is_closed();
}

TEST_F(ShaderEditTest, BrokenFromTheBeginningTheyAreNamedUntilTheyAreMended) {
  write(kShader, broken_);
  open_window();
  EXPECT_TRUE(comes_to_show("problem = "));
  EXPECT_TRUE(says(read("places"), {place_, "imageStrore"}));
  std::this_thread::sleep_for(std::chrono::seconds(1));
  write(kShader, red_);
  EXPECT_TRUE(comes_to_show("problem = ", false));
  expect_red_once_it_is_closed();
}

TEST_F(ShaderEditTest, WithoutAWindowBrokenOnesAreBadInput) {
  write(kShader, broken_);
  const Outcome outcome = run({"compare", "quads_mcguire", "--methods", "wboit", "--size", "48x27",
                               "--frames", "1", "--shaders", "shaders"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_TRUE(says(outcome.err, {place_, "imageStrore"}));
  EXPECT_EQ(files(), (std::vector<std::string>{"results.csv", "results.json"}));
}

TEST_F(WindowTest, LostDeviceNamesThePass) {
  const Outcome outcome = open({"open", "street"}, {{"PLUME_FAULT", "device_lost@draw"}});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_TRUE(says(outcome.err, {"the device was lost", "'draw'"}));
}

}  // namespace
}  // namespace plume
