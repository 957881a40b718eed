// The effects panel, driven with mouse and keys as by a person (xdotool).
#include <fmt/format.h>

#include <functional>
#include <optional>
#include <sstream>

#include "tests/command/far_particles.h"
#include "tests/command/program.h"
#include "tests/command/virtual_display.h"

namespace plume {
namespace {

constexpr std::string_view kEffect = R"(# kept
name = "Small"

[[emitter]]
name = "puffs"
  [emitter.spawn]
  rate = 60.0   # a second
  duration = 100
  life = [20, 40]
  [emitter.shape]
  kind = "sphere"
  radius_m = 0.50
  [emitter.look]
  radius_m = 0.2
  opacity = 0.5
  fade = [[0.0, 1.0], [1.0, 0.0]]   # out
)";

constexpr std::string_view kScene = R"(name = "One"
duration_ticks = 200
[camera]
position = [0.0, 1.0, 6.0]
target = [0.0, 1.0, 0.0]
[[solid]]
kind = "plane"
size_m = [40.0, 40.0]
[[instance]]
name = "it"
effect = "small"
call_tick = 0
position = [0.0, 1.0, 0.0]
)";

/// Of a window that is closed by a signal.
constexpr const char* kNoComplaint = "plume: interrupted; settings and what was recorded are kept\n";

class EffectsPanel : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v xdotool > /dev/null") != 0) GTEST_SKIP() << "install the package xdotool";
    display_.emplace();
    if (!display_->works()) GTEST_SKIP() << "Xvfb does not start; install the package xvfb";
    write("presets/effects/small.toml", kEffect);
    write("presets/scenes/one.toml", kScene);
    open_window("one", "30");
  }
  void open_window(const std::string& scene, const std::string& tick) {
    Environment environment = display_->environment();
    environment["PLUME_PRESETS"] = at("presets");
    environment["PLUME_WIDGET_PLACES"] = at("places");
    fs::remove(at("places"));
    window_ = start({"open", scene, "--at", tick, "--validate"}, environment);
    if (!until([&] { return fs::exists(at("places")); })) {
      const Outcome outcome = close();
      if (says(outcome.err, {"this build has no window"})) GTEST_SKIP() << "there is no window to open";
      FAIL() << outcome.err;
    }
  }
  void TearDown() override {
    if (window_ > 0) close();
    ProgramTest::TearDown();
  }

  static bool until(const std::function<bool()>& holds, double seconds = 20) {
    for (const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
         std::chrono::steady_clock::now() < end; std::this_thread::sleep_for(std::chrono::milliseconds(20)))
      if (holds()) return true;
    return false;
  }

  /// The middle of a widget, once it is there and stays where it is.
  std::optional<std::pair<int, int>> middle(const std::string& widget) {
    std::optional<std::pair<int, int>> found, before;
    until([&] {
      before = found, found.reset();
      std::istringstream lines(read("places"));
      int left = 0, top = 0, right = 0, bottom = 0;
      for (std::string name; lines >> left >> top >> right >> bottom && std::getline(lines >> std::ws, name);)
        if (name == widget) found = {(left + right) / 2, (top + bottom) / 2};
      return found && found == before;
    });
    return found;
  }
  /// xdotool's own words; it waits until the window has had time for each.
  void act(const std::string& what) {
    const std::string command =
        fmt::format("DISPLAY={} xdotool {}", display_->environment()["DISPLAY"], what);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
  }
  void move_to(const std::string& widget, int right = 0) {
    const auto place = middle(widget);
    ASSERT_TRUE(place) << widget << " is not among\n" << read("places");
    act(fmt::format("mousemove {} {}", place->first + right, place->second));
  }
  void click(const std::string& widget) {
    move_to(widget);
    act("mousedown 1");
    act("mouseup 1");
  }
  /// Before the first picture, perhaps; that must not lose it.
  void select_emitter(const std::string& field) {
    click("it / puffs");
    ASSERT_TRUE(until([&] { return is_there(field); })) << field;
  }
  /// What the file has once it is not `before` any more.
  std::string saved_after(const std::string& before, double seconds = 5) {
    act("key ctrl+s");
    until([&] { return effect() != before; }, seconds);
    return effect();
  }
  bool is_there(const std::string& widget) const {
    return read("places").find(" " + widget + "\n") != std::string::npos;
  }
  /// An effect is dropped on the floor through the list of pictures.
  void drop_effect(int x, int y) {
    for (int i = 0; i < 10 && !is_there("effect: small"); ++i) {
      click("drop");
      until([&] { return is_there("effect: small"); }, 1);
    }
    click("effect: small");
    act(fmt::format("mousemove {} {}", x, y));
    act("mousedown 1");
    act("mouseup 1");
    EXPECT_TRUE(until([&] { return is_there("mark of small"); })) << read("places");
  }
  /// As the desktop does for the button that closes a window.
  void ask_to_close() {
    const std::string command = fmt::format("DISPLAY={} xdotool search --onlyvisible --name Plume",
                                            display_->environment()["DISPLAY"]);
    FILE* answer = popen(command.c_str(), "r");
    unsigned long window = 0;
    ASSERT_EQ(std::fscanf(answer, "%lu", &window), 1);
    pclose(answer);
    display_->ask_to_close(window);
  }
  std::string scene() const { return read("presets/scenes/one.toml"); }
  std::string effect() const { return read("presets/effects/small.toml"); }
  Outcome close() {
    kill(window_, SIGTERM);
    const Outcome outcome = wait(window_);
    window_ = -1;
    return outcome;
  }

  std::optional<VirtualDisplay> display_;
  pid_t window_ = -1;
};

std::string with(std::string_view text, std::string_view old, std::string_view by) {
  std::string changed(text);
  return changed.replace(changed.find(old), old.size(), by);
}

TEST_F(EffectsPanel, ADraggedNumberIsSavedAndUndone) {
  const std::string radius = "emitter[0].shape.radius_m";
  select_emitter(radius);
  move_to(radius);
  act("mousedown 1");
  for (int i = 1; i <= 4; ++i) move_to(radius, 10 * i);
  act("mouseup 1");
  EXPECT_EQ(effect(), kEffect) << "not saved yet";
  act("key ctrl+s");
  ASSERT_TRUE(until([&] { return effect() != kEffect; }));
  const std::string saved = effect(), before = "  radius_m = ";
  const size_t at = saved.find(before) + before.size();
  const std::string number = saved.substr(at, saved.find('\n', at) - at);
  EXPECT_EQ(saved, with(kEffect, "0.50", number)) << "one number, and nothing else";
  EXPECT_GT(std::stof(number), 0.5f);

  act("key ctrl+z");
  act("key ctrl+s");
  EXPECT_TRUE(until([&] { return effect() == kEffect; })) << effect();
  act("key ctrl+shift+z");
  act("key ctrl+s");
  EXPECT_TRUE(until([&] { return effect() == saved; })) << effect();

  write("presets/effects/small.toml", with(kEffect, "rate = 60.0", "rate = oops"));
  std::this_thread::sleep_for(std::chrono::milliseconds(600));
  act("mousemove 640 400 key Escape");
  const Outcome outcome = wait(window_);
  window_ = -1;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
}

TEST_F(EffectsPanel, AnEffectIsDroppedMovedSavedRemovedAndBroughtBack) {
  drop_effect(560, 560);
  EXPECT_EQ(scene(), kScene) << "not saved yet";
  act("key ctrl+s");
  ASSERT_TRUE(until([&] { return scene() != kScene; }));
  const std::string dropped = scene();
  ASSERT_TRUE(dropped.starts_with(kScene)) << dropped;
  EXPECT_TRUE(says(dropped.substr(kScene.size()),
                   {"[[instance]]", "effect = \"small\"", "call_tick = 30", "position = ["}));

  move_to("mark of small");
  act("mousedown 1");
  for (int i = 1; i <= 3; ++i) act("mousemove_relative 20 0");
  act("mouseup 1");
  act("key ctrl+s");
  ASSERT_TRUE(until([&] { return scene() != dropped; }));
  const std::string moved = scene();
  const auto number = [](const std::string& text, int which) {
    size_t at = text.rfind("position = [") + 11;
    for (; which > 0; --which) at = text.find(',', at + 1);
    return std::stod(text.substr(at + 1));
  };
  EXPECT_GT(number(moved, 0), number(dropped, 0) + 0.1);
  EXPECT_EQ(number(moved, 1), number(dropped, 1)) << "on its level";

  act("key Delete");
  act("key ctrl+s");
  EXPECT_TRUE(until([&] { return scene() == kScene; })) << scene();
  for (const std::string& before : {moved, dropped, std::string(kScene)}) {
    act("key ctrl+z");
    act("key ctrl+s");
    EXPECT_TRUE(until([&] { return scene() == before; })) << scene();
  }
}

TEST_F(EffectsPanel, ClosingAsksWhatBecomesOfWhatIsNotSaved) {
  drop_effect(560, 560);
  ask_to_close();
  ASSERT_TRUE(until([&] { return is_there("Discard"); }));
  act("key Escape");
  ASSERT_TRUE(until([&] { return !is_there("Discard"); }));
  EXPECT_EQ(scene(), kScene);
  act("key ctrl+q");
  click("Save");
  const Outcome outcome = wait(window_);
  window_ = -1;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(scene(), kScene);
}

TEST_F(EffectsPanel, ASceneIsPickedByItsPictureAndSavedUnderAnotherName) {
  write("presets/scenes/two.toml", with(kScene, "\"One\"", "\"Two\""));
  for (int i = 0; i < 10 && !is_there("scene: two"); ++i) {
    click("scene = one");
    until([&] { return is_there("scene: two"); }, 1);
  }
  act("key Escape");
  ASSERT_TRUE(until([&] { return !is_there("scene: two"); })) << "Esc closes the list, and nothing else";
  click("scene = one");
  act("type TW");
  ASSERT_TRUE(until([&] { return !is_there("scene: one"); })) << "what is typed is looked for";
  click("scene: two");
  ASSERT_TRUE(until([&] { return !is_there("scene: two"); })) << "the list closes";
  act("mousemove 640 300 key ctrl+shift+s");
  click("save as name");
  ASSERT_TRUE(until([&] { return fs::exists(at("presets/scenes/two_2.toml")); }));
  EXPECT_TRUE(says(read("presets/scenes/two_2.toml"), {"name = \"two_2\"", "effect = \"small\""}));
  EXPECT_TRUE(until([&] { return fs::exists(at("presets/pictures/scenes/two_2.png")); }));
  act("key ctrl+q");
  const Outcome outcome = wait(window_);
  window_ = -1;
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(says(read("config/settings.toml"), {"scene = \"two_2\""}));
}

std::string fade_of(const std::string& effect) {
  const size_t at = effect.find("fade = "), end = effect.find("   # out", at);
  return at == effect.npos || end == effect.npos ? effect : effect.substr(at, end - at);
}

TEST_F(EffectsPanel, AKeyOfACurveIsMadeDraggedAndTakenAway) {
  const std::string original(kEffect);
  select_emitter("only set");
  click("only set");
  click("emitter[0].look.fade over life");
  act("mousemove 12 500 click --repeat 8 5");  // all of it into the panel
  const auto canvas = middle("curve");
  ASSERT_TRUE(canvas) << read("places");

  std::string made = original;
  for (int i = 0; i < 5 && made == original; ++i) {  // a busy machine may be too slow for a double click
    act(fmt::format("mousemove {} {} click --repeat 2 --delay 100 1", canvas->first, canvas->second - 20));
    made = saved_after(original, 2);
  }
  EXPECT_EQ(std::ranges::count(fade_of(made), '['), 4) << "a third key: " << fade_of(made);

  act("mousedown 1");
  for (int i = 1; i <= 4; ++i)
    act(fmt::format("mousemove {} {}", canvas->first + 5 * i, canvas->second - 20 + 8 * i));
  act("mouseup 1");
  const std::string dragged = saved_after(made);
  EXPECT_NE(fade_of(dragged), fade_of(made));
  EXPECT_EQ(std::ranges::count(fade_of(dragged), '['), 4) << fade_of(dragged);
  act("key ctrl+z");
  EXPECT_EQ(saved_after(dragged), made) << "a drag is one step";
  act("key ctrl+shift+z");
  EXPECT_EQ(saved_after(made), dragged);

  act("click 3");
  EXPECT_EQ(fade_of(saved_after(dragged)), "fade = [[0.0, 1.0], [1.0, 0.0]]");
  EXPECT_EQ(close().err, kNoComplaint);
}

TEST_F(EffectsPanel, ALinePointsAtTheEmitterOfBadParticles) {
  close();
  write("presets/effects/far.toml", kFarEffect);
  write("presets/scenes/far.toml", kFarScene);
  open_window("far", kTooFarTick);
  const std::string line =
      "bad particles = 4 particles are not finite, and left out; first: far (it) / runaway #0";
  EXPECT_FALSE(is_there("emitter[1].parent.inherit_velocity"));
  click(line);
  EXPECT_TRUE(until([&] { return is_there("emitter[1].parent.inherit_velocity"); })) << read("places");
  EXPECT_EQ(close().err, kNoComplaint);
}

}  // namespace
}  // namespace plume
