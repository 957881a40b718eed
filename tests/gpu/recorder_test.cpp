// A session, driven by a script instead of a hand, and what can be taken out of it.
#include "sandbox/workspace/recorder.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>
#include <random>

#include "sandbox/measure/image_io.h"
#include "sandbox/presets/read_replay.h"
#include "sandbox/workspace/recording.h"
#include "sandbox/workspace/settings.h"
#include "sandbox/workspace/shown_picture.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

namespace fs = std::filesystem;
constexpr glm::uvec2 kSize{64, 36};

class SessionTest : public GpuTest {
 protected:
  SessionTest() { fs::remove_all(folder); }
  ~SessionTest() override { fs::remove_all(folder); }

  Workspace open(const std::string& scene, uint32_t tick) {
    Scene read = library.scene(scene);
    return Workspace(device, pipelines, library, read, Playback(tick, read.duration_ticks, false));
  }
  void choose(Workspace& workspace, Side& side, const std::string& id) {
    for (size_t i = 0; i < side.methods.size(); ++i)
      if (side.methods[i].method->id() == id) workspace.choose_method(side, i);
  }

  const fs::path folder =
      fs::path(testing::TempDir()) /
      (std::string("plume_session_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

/// Records, and keeps what was seen.
class RecorderTest : public SessionTest {
 protected:
  void draw(Workspace& workspace, glm::uvec2 size = kSize) {
    workspace.draw(size);
    recorder.note(workspace);
    for (Side* side : {&workspace.a, &workspace.b})
      if (workspace.shows(*side)) seen.push_back(read_picture(device, *side->targets).display);
  }
  /// Saves, lets the program play it, and compares.
  void expect_replay_shows_what_was_seen() {
    const fs::path file = folder / "my recording.toml";
    recorder.save(file, library);
    EXPECT_FALSE(recorder.is_recording());
    const std::string command = fmt::format(
        "PLUME_CACHE=off PLUME_PRESETS='{}' '{}' replay '{}' --out '{}' >'{}' 2>&1", PLUME_SOURCE_PRESETS,
        PLUME_PROGRAM, file.string(), (folder / "out").string(), (folder / "said").string());
    ASSERT_EQ(std::system(command.c_str()), 0) << said();
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder / "out"))
      if (entry.path().extension() == ".png") files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_EQ(files.size(), seen.size());
    for (size_t i = 0; i < files.size(); ++i)
      EXPECT_TRUE(read_png(files[i]).pixels == seen[i].pixels) << files[i].filename();
  }
  std::string said() const {
    std::ifstream in(folder / "said");
    return {std::istreambuf_iterator<char>(in), {}};
  }

  Recorder recorder;
  std::vector<DisplayImage> seen;
};

TEST_F(RecorderTest, ReplayShowsWhatWasSeenToTheBit) {
  Workspace workspace = open("quads_mcguire", 0);
  draw(workspace);  // before: not recorded
  seen.clear();
  recorder.start(workspace);
  draw(workspace);
  workspace.set_camera({.position = {0.3f, 0.2f, 4.1f}, .target = {0.05f, 0, 0}, .vertical_fov_deg = 38.7f});
  draw(workspace);
  choose(workspace, workspace.a, "wboit");
  draw(workspace);
  set_parameter(*workspace.a.method().method, "weight", "eq9");
  set_parameter(*workspace.a.method().method, "depth_scale", "0.3");
  draw(workspace);
  draw(workspace, {50, 41});
  workspace.compare(Comparison::kSplit);
  choose(workspace, workspace.b, "sorted");
  draw(workspace);
  workspace.follow_scene_camera();
  workspace.compare(Comparison::kFlip);
  draw(workspace);
  EXPECT_EQ(recorder.shots(), seen.size());
  expect_replay_shows_what_was_seen();
}

TEST_F(RecorderTest, RecordingThatDoesNotFitLeavesNothingAndCanBeSavedLater) {
  Workspace workspace = open("grenade", 100);
  choose(workspace, workspace.a, "wboit");
  recorder.start(workspace);
  draw(workspace);
  workspace.change_scene([](Scene& scene) { scene.light.sun_color = {1, 0.1f, 0.2f}; });
  draw(workspace);
  fs::create_directories(folder);
  const fs::path file = folder / "recorded.toml";
  const auto files = [&] {
    size_t count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.path().filename() != "";
    return count;
  };
  const size_t before = files();
  signal(SIGXFSZ, SIG_IGN);
  rlimit unlimited{};
  getrlimit(RLIMIT_FSIZE, &unlimited);
  int failures = 0;
  for (rlim_t bytes = 0; recorder.is_recording(); bytes += 50, ++failures) {
    EXPECT_EQ(files(), before) << bytes;
    const rlimit limit{bytes, unlimited.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      recorder.save(file, library);
    } catch (const FileError&) {
    }
    setrlimit(RLIMIT_FSIZE, &unlimited);
  }
  EXPECT_GT(failures, 5);
  EXPECT_EQ(read_replay(file).shots.size(), 2u);
}

TEST_F(RecorderTest, ReplayShowsScenesAndEffectsAsTheyWereThen) {
  // A library of one's own, whose effect changes while one records.
  fs::create_directories(folder / "presets");
  for (const char* kind : {"effects", "scenes", "meshes"})
    fs::copy(fs::path(PLUME_SOURCE_PRESETS) / kind, folder / "presets" / kind);
  library = PresetLibrary(folder / "presets");
  Workspace workspace = open("grenade", 100);
  choose(workspace, workspace.a, "wboit");
  recorder.start(workspace);
  draw(workspace);
  workspace.change_scene([](Scene& scene) { scene.light.sun_color = {1, 0.1f, 0.2f}; });
  draw(workspace);
  const fs::path smoke = library.find(PresetKind::kEffect, workspace.scene().instances.at(0).effect);
  std::string text = library.effect(smoke.string()).text;
  const size_t life = text.find("life = [");
  ASSERT_NE(life, text.npos);
  text.replace(life, text.find(']', life) - life, "life = [40, 60");
  std::ofstream(smoke) << text;
  workspace.open_scene("grenade");
  workspace.playback.go_to(100);
  draw(workspace);
  EXPECT_EQ(recorder.shots(), 3u);
  EXPECT_NE(seen[2].pixels, seen[0].pixels);
  EXPECT_NE(seen[1].pixels, seen[0].pixels);
  library = PresetLibrary(PLUME_SOURCE_PRESETS);
  expect_replay_shows_what_was_seen();
  EXPECT_TRUE(fs::exists(folder / "my recording/scenes/2/grenade.toml"));
  EXPECT_TRUE(fs::exists(folder / "my recording/effects/3" / smoke.filename()));
}

TEST_F(RecorderTest, ReplayRemembersWhatWasNotLookedAt) {
  Workspace workspace = open("campfire", 200);
  choose(workspace, workspace.a, "wboit");
  const CameraKey away{.position = {0, 1, 300}, .target = {0, 1, 400}};
  const auto look_away = [&] {  // the fire stands still behind one's back
    workspace.set_camera(away);
    for (int i = 0; i < 20; ++i) {
      workspace.playback.step_forward();
      draw(workspace);
    }
    for (const InstanceDemand& instance : workspace.stage().demand()) EXPECT_FALSE(instance.awake);
    workspace.follow_scene_camera();
    draw(workspace);
  };
  draw(workspace);
  look_away();
  seen.clear();
  recorder.start(workspace);
  draw(workspace);
  look_away();
  expect_replay_shows_what_was_seen();
}

// ---- whatever one does -----------------------------------------------------------------------------------

constexpr std::string_view kPuffs = R"(name = "Puffs"
[[emitter]]
name = "puffs"
  [emitter.spawn]
  rate = 60.0
  duration = 300
  life = [20, 40]
  [emitter.shape]
  kind = "sphere"
  radius_m = 0.5
  [emitter.look]
  radius_m = 0.3
  opacity = 0.5
)";

constexpr std::string_view kYard = R"(name = "Yard"
duration_ticks = 300
[[camera]]
tick = 0
position = [0.0, 1.0, 6.0]
target = [0.0, 1.0, 0.0]
[[camera]]
tick = 100
position = [2.0, 1.5, 6.0]
target = [0.5, 1.0, 0.0]
[[solid]]
kind = "plane"
size_m = [40.0, 40.0]
[[pane]]
position = [0.5, 1.0, 1.0]
size_m = [1.0, 1.5]
transmission = [0.9, 0.3, 0.2]
[[instance]]
name = "frozen for a while"
effect = "puffs"
call_tick = 0
freeze = [[40, 60], [80, 90]]
position = [-1.0, 1.0, 0.0]
[[instance]]
name = "waits to be seen"
effect = "pausing"
call_tick = 5
position = [1.0, 1.0, 0.0]
seed = 2
[[instance]]
name = "hot air"
effect = "heat_haze"
call_tick = 0
position = [0.0, 0.5, 2.0]
)";

/// Somebody who does this and that, the same for the same seed.
class Visitor {
 public:
  Visitor(Workspace& workspace, uint32_t seed) : workspace_(workspace), random_(seed) {}

  void act() {
    switch (number(14)) {
      case 0:
        return workspace_.choose_method(side(), method());
      case 1:
        return turn_a_knob();
      case 2:
        return workspace_.set_camera(
            {.position = {place(3), 1 + place(1), 5 + place(2)}, .target = {0, 1, 0}});
      case 3:
        return workspace_.set_camera({.position = {0, 1, 100}, .target = {0, 1, 200}});  // away
      case 4:
        return workspace_.follow_scene_camera();
      case 5:
        return workspace_.playback.go_to(number(150));
      case 6:
        return workspace_.playback.step_forward();
      case 7:
        return workspace_.compare(Comparison(number(3)));
      case 8:
        return flip(number(2) ? workspace_.switches.muted : workspace_.switches.solo);
      case 9:
        return freeze();
      case 10:
        return edit();
      case 11:
        return look();
      case 12:
        workspace_.drop_effect("puffs", {0.5f, 0.9f});
        return;
      default:
        return workspace_.open_scene(number(3) ? "yard" : "quads_mcguire");
    }
  }
  glm::uvec2 size() { return number(4) ? glm::uvec2(48, 27) : glm::uvec2(40, 30); }

 private:
  uint32_t number(uint32_t below) { return uint32_t(random_()) % below; }
  float place(float most) { return most * (float(number(2001)) / 1000 - 1); }
  Side& side() { return number(2) ? workspace_.a : workspace_.b; }
  size_t method() {
    constexpr std::array kQuick{"avboit", "wboit", "moments", "sorted"};
    const auto& methods = workspace_.a.methods;
    const auto found = std::ranges::find(methods, kQuick[number(kQuick.size())], &MethodInstance::owner);
    return size_t(found - methods.begin());
  }
  void turn_a_knob() {
    Method& method = *side().method().method;
    const auto list = parameter_list(method);
    const auto& knob = list.at(number(uint32_t(list.size())));
    if (knob["type"] == "number") {
      const double low = knob["min"], high = knob["max"];
      set_parameter(method, knob["name"].get<std::string>(),
                    std::to_string(low + (high - low) * number(8) / 7));
    } else if (knob["type"] == "toggle") {
      set_parameter(method, knob["name"].get<std::string>(), number(2) ? "true" : "false");
    }
    workspace_.change();
  }
  std::optional<size_t> instance() {
    const size_t count = workspace_.scene().instances.size();
    return count ? std::optional(number(uint32_t(count))) : std::nullopt;
  }
  void flip(std::set<size_t>& set) {
    if (const auto one = instance(); one && !set.erase(*one)) set.insert(*one);
  }
  void freeze() {
    if (const auto one = instance(); one && !workspace_.switches.frozen.erase(*one))
      workspace_.switches.frozen[*one] = workspace_.playback.tick();
  }
  void edit() {
    PresetDocument& document = workspace_.documents.open(number(2) ? "puffs" : "pausing");
    if (number(3))
      document.set(number(2) ? "emitter[0].shape.radius_m" : "emitter[0].look.feather_m",
                   0.1f + 0.1f * float(number(5)));
    else
      document.undo();
  }
  void look() {
    Side& which = side();
    const auto views = Inspector::inspections(*which.method().method);
    which.view.id.clear();
    if (number(4) == 0) return workspace_.change();
    const Inspection& view = views[number(uint32_t(views.size()))];
    which.view.choose(view);
    which.view.slice = number(std::max(view.slices, 1u));
    if (number(2)) which.view.logarithmic = !which.view.logarithmic;
    which.view.range = SideView::Range(number(3));
    which.view.held = {0.1f, 2.3f};
    workspace_.change();
  }

  Workspace& workspace_;
  std::mt19937 random_;
};

TEST_F(RecorderTest, ReplayShowsWhateverOneDoes) {
  fs::create_directories(folder / "presets/effects");
  fs::create_directories(folder / "presets/scenes");
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / "presets" / name) << text;
  };
  write("effects/puffs.toml", std::string(kPuffs));
  write("effects/pausing.toml", "off_screen = \"pause\"\n" + std::string(kPuffs));
  write("scenes/yard.toml", std::string(kYard));
  for (const char* shipped : {"effects/heat_haze.toml", "scenes/quads_mcguire.toml"})
    fs::copy(fs::path(PLUME_SOURCE_PRESETS) / shipped, folder / "presets" / shipped);
  library = PresetLibrary(folder / "presets");
  Workspace workspace = open("yard", 30);
  const char* other = std::getenv("PLUME_VISITOR");  // who does other things
  Visitor visitor(workspace, other ? uint32_t(std::atoi(other)) : 7);
  recorder.start(workspace);
  for (int i = 0; i < 30; ++i) {
    visitor.act();
    draw(workspace, visitor.size());
    const size_t shots = recorder.shots();
    if (seen.size() > shots) seen.resize(shots);  // nothing had changed
  }
  EXPECT_GT(recorder.shots(), 18u);
  library = PresetLibrary(PLUME_SOURCE_PRESETS);
  expect_replay_shows_what_was_seen();
}

TEST_F(RecorderTest, ReplayForgetsWhenTheSceneBeganAnew) {
  Workspace workspace = open("campfire", 200);
  choose(workspace, workspace.a, "wboit");
  recorder.start(workspace);
  draw(workspace);
  workspace.set_camera({.position = {0, 1, 300}, .target = {0, 1, 400}});  // the fire stands still
  workspace.playback.go_to(260);
  draw(workspace);
  workspace.follow_scene_camera();
  draw(workspace);
  workspace.change_scene([](Scene&) {});  // alike, but nothing of it was ever out of sight
  draw(workspace);
  EXPECT_NE(seen[2].pixels, seen[3].pixels);
  expect_replay_shows_what_was_seen();
}

TEST_F(RecorderTest, ReplayHearsOnlyWhoWasHeard) {
  Workspace workspace = open("haze", 300);
  choose(workspace, workspace.a, "wboit");
  recorder.start(workspace);
  draw(workspace);
  for (size_t i = 0; i < workspace.scene().instances.size(); ++i) workspace.switches.muted.insert(i);
  draw(workspace);
  EXPECT_FALSE(workspace.stage().post().distortion) << "what is muted bends no light";
  workspace.switches.muted.clear();
  workspace.switches.frozen[0] = 100;
  draw(workspace);
  EXPECT_NE(seen[0].pixels, seen[1].pixels);
  EXPECT_NE(seen[0].pixels, seen[2].pixels);
  expect_replay_shows_what_was_seen();
}

TEST_F(SessionTest, PicturesOfARangeAreRecordedToo) {
  Workspace workspace = open("quads_mcguire", 0);
  Recording recording;
  fs::create_directories(folder);
  recording.folder = folder;
  recording.toggle(workspace);
  recording.start_pictures(workspace, {.first = 1, .last = 3, .size = kSize});
  while (recording.is_busy()) recording.advance(workspace);
  EXPECT_EQ(workspace.problem, "");
  EXPECT_EQ(recording.recorder().shots(), 3u);
}

TEST_F(RecorderTest, TakesAPictureDownOnceWhileItStaysTheSame) {
  Workspace workspace = open("quads_mcguire", 0);
  recorder.start(workspace);
  for (int i = 0; i < 3; ++i) draw(workspace);
  EXPECT_EQ(recorder.shots(), 1u);
  workspace.compare(Comparison::kSplit);
  for (int i = 0; i < 3; ++i) draw(workspace);
  EXPECT_EQ(recorder.shots(), 3u);
  workspace.compare(Comparison::kNone);
  draw(workspace);
  EXPECT_EQ(recorder.shots(), 4u);
}

TEST_F(RecorderTest, SavesNoRecordingOfNothing) {
  Workspace workspace = open("quads_mcguire", 0);
  recorder.start(workspace);
  EXPECT_THROW(recorder.save(folder / "nothing.toml", library), std::runtime_error);
  EXPECT_FALSE(fs::exists(folder));
}

TEST_F(SessionTest, PicturesOfARangeAreThoseOfItsTicksAndLeaveTheWorkspaceAsItWas) {
  Workspace workspace = open("grenade", 30);
  choose(workspace, workspace.a, "wboit");
  workspace.playback.toggle();
  workspace.resolution.set_step(4);
  {
    ImageSequence sequence(
        workspace, {.folder = folder / "pictures", .first = 60, .last = 65, .step = 2, .size = kSize});
    EXPECT_EQ(sequence.total(), 3u);
    while (!sequence.is_done()) sequence.advance();
  }
  EXPECT_TRUE(workspace.playback.playing());
  EXPECT_EQ(workspace.playback.tick(), 30u);
  EXPECT_EQ(workspace.resolution.step(), 4u);
  EXPECT_TRUE(workspace.is_outdated());
  workspace.resolution.set_step(0);
  workspace.playback.go_to(64);
  workspace.draw(kSize);
  EXPECT_EQ(read_png(folder / "pictures/frame_000003.png").pixels, shown_picture(workspace).pixels);
  EXPECT_FALSE(fs::exists(folder / "pictures/frame_000004.png"));
}

TEST_F(SessionTest, PictureOfASplitViewHasBothSides) {
  Workspace workspace = open("quads_mcguire", 0);
  workspace.compare(Comparison::kSplit);
  choose(workspace, workspace.b, "wboit");
  workspace.divider = 0.25f;
  workspace.draw(kSize);
  const DisplayImage both = shown_picture(workspace);
  const DisplayImage a = read_picture(device, *workspace.a.targets).display;
  const DisplayImage b = read_picture(device, *workspace.b.targets).display;
  ASSERT_NE(a.pixels, b.pixels);
  for (int y = 0; y < both.height; ++y)
    for (int x = 0; x < both.width; ++x) EXPECT_EQ(both.at(x, y), (x < 16 ? a : b).at(x, y));
}

TEST_F(SessionTest, SettingsCarryMethodsAndParametersOver) {
  Settings settings;
  {
    Workspace workspace = open("quads_mcguire", 0);
    choose(workspace, workspace.a, "wboit");
    choose(workspace, workspace.b, "moments");
    set_parameter(*workspace.a.method().method, "depth_scale", "0.3");
    workspace.resolution = {};
    workspace.resolution.set_step(3);
    workspace.resolution.frames_per_second = 24;
    take_settings(workspace, settings);
  }
  settings = read_settings_text(settings_text(settings), "x");
  EXPECT_EQ(settings.a.parameters.size(), 1u);
  settings.a.parameters["gone"] = {{"x", "1"}};
  settings.a.parameters["wboit"]["gone too"] = "1";
  Workspace workspace = open("quads_mcguire", 0);
  EXPECT_EQ(apply_settings(settings, workspace).size(), 2u);
  EXPECT_EQ(workspace.a.method().method->id(), "wboit");
  EXPECT_EQ(workspace.b.method().method->id(), "moments");
  EXPECT_EQ(parameter_texts(*workspace.a.method().method).at("depth_scale"), "0.3");
  EXPECT_EQ(workspace.resolution.step(), 3u);
  EXPECT_EQ(workspace.resolution.frames_per_second, 24);
}

}  // namespace
}  // namespace plume
