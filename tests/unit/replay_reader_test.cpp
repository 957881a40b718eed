#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "renderer/methods/method.h"
#include "renderer/methods/methods.h"
#include "sandbox/presets/diagnostics.h"
#include "sandbox/presets/read_replay.h"

namespace plume {
namespace {

/// Every key a replay can have, but for the settings of methods.
constexpr std::string_view kEveryKey = R"(
name = "Every key"
scene = "street"
seed = 9
size = [1280, 720]
ticks = { first = 10, last = 31, step = 10 }
frames = 5
warmup = 2

[[camera]]
tick = 0
position = [0, 1, 5]
target = [0, 1, 0]
vertical_fov_deg = 60

[[method]]
id = "avboit"
[[method]]
id = "wboit"

[capture]
ticks = [20, 30]
images = false
error_maps = false
hdr = true
pixels = [[640, 100], [0, 719]]
)";

constexpr std::string_view kHead = "name = 'x'\nscene = 's'\nticks = [0]\n";

TEST(ReplayReader, ReadsEveryKey) {
  const Replay replay = read_replay_text(kEveryKey, "a/every_key.toml");
  EXPECT_EQ(replay.id, "every_key");
  EXPECT_EQ(replay.name, "Every key");
  EXPECT_EQ(replay.scene, "street");
  EXPECT_EQ(replay.scene_at.line, 3u);
  EXPECT_EQ(replay.scene_at.column, 9u);
  EXPECT_EQ(replay.seed, 9u);
  EXPECT_EQ(replay.size, glm::uvec2(1280, 720));
  EXPECT_EQ(replay.ticks, (std::vector<uint32_t>{10, 20, 30}));
  EXPECT_EQ(replay.frames, 5u);
  EXPECT_EQ(replay.warmup, 2u);
  ASSERT_EQ(replay.camera.size(), 1u);
  EXPECT_EQ(replay.camera[0].vertical_fov_deg, 60.0f);
  ASSERT_EQ(replay.methods.size(), 2u);
  EXPECT_EQ(replay.methods[0].id, "avboit");
  EXPECT_EQ(replay.methods[1].id, "wboit");
  EXPECT_EQ(replay.capture.ticks, (std::vector<uint32_t>{20, 30}));
  EXPECT_FALSE(replay.capture.images);
  EXPECT_FALSE(replay.capture.error_maps);
  EXPECT_TRUE(replay.capture.hdr);
  EXPECT_EQ(replay.capture.pixels, (std::vector<glm::uvec2>{{640, 100}, {0, 719}}));
}

TEST(ReplayReader, LeavesWhatIsNotSaidAtItsDefault) {
  const Replay replay = read_replay_text(std::string(kHead) + "[[method]]\nid = 'wboit'\n", "x.toml");
  EXPECT_FALSE(replay.seed.has_value());
  EXPECT_EQ(replay.size, Replay{}.size);
  EXPECT_TRUE(replay.camera.empty());
  EXPECT_TRUE(replay.capture.ticks.empty());
}

TEST(ReplayReader, ReadsSweepsAsReplaysOfTheirOwn) {
  const Replay replay = read_replay_text(R"(
name = "Sweep"
size = [8, 8]
frames = 7
[[sweep]]
scenes = ["a", "b"]
ticks = { first = 1, last = 3 }
sizes = [[16, 9], [32, 18]]
seeds = [4, 5]
[[sweep.method]]
id = "avboit"
slices = ["32", "64", "128"]
half_particles = [true, false]
[[sweep]]
scenes = "c"
[[sweep.method]]
id = "wboit"
)",
                                         "a/sweep.toml");
  EXPECT_EQ(replay.sweeps.at(1).at.line, 14u);
  EXPECT_EQ(replay.sweeps.at(0).scenes_at.line, 6u);
  EXPECT_EQ(jobs_of(replay.sweeps[0]), 2 * 3 * 2 * 2 * 6);
  const std::vector<Replay> all = expand(replay);
  ASSERT_EQ(all.size(), 9u);  // by scene, size and seed
  for (const Replay& one : all) {
    EXPECT_TRUE(one.sweeps.empty());
    EXPECT_EQ(one.id, "sweep");
    EXPECT_EQ(one.frames, 7u);
  }
  EXPECT_EQ(all[1].scene, "a");
  EXPECT_EQ(all[1].size, glm::uvec2(16, 9));
  EXPECT_EQ(all[1].seed, 5u);
  EXPECT_EQ(all[1].ticks, (std::vector<uint32_t>{1, 2, 3}));
  EXPECT_EQ(all[7].scene, "b");
  EXPECT_EQ(all[7].size, glm::uvec2(32, 18));
  std::set<std::map<std::string, std::string>> settings;
  for (const MethodRun& run : all[1].methods) settings.insert(run.settings);
  EXPECT_EQ(settings.size(), 6u);
  EXPECT_EQ(all[8].size, glm::uvec2(8, 8));
  EXPECT_TRUE(all[8].ticks.empty());
  EXPECT_FALSE(all[8].seed.has_value());
}

TEST(ReplayReader, TakesEveryParameterOfEveryMethodAtItsDefault) {
  for (const std::string& id : method_ids()) {
    const nlohmann::json list = parameter_list(*make_method(id));
    std::string text = std::string(kHead) + "[[method]]\nid = '" + id + "'\n";
    for (const auto& parameter : list)
      text += parameter["name"].get<std::string>() + " = " + parameter["value"].dump() + "\n";
    const MethodRun run = read_replay_text(text, "x.toml").methods.at(0);
    EXPECT_EQ(run.settings.size(), list.size()) << id;
    for (const auto& parameter : list) {
      const std::string name = parameter["name"];
      const std::string value =
          parameter["value"].is_string() ? parameter["value"].get<std::string>() : parameter["value"].dump();
      // 1.0 in the file is the number 1, and may be kept as either.
      if (parameter["type"] == "number")
        EXPECT_EQ(std::stod(run.settings.at(name)), parameter["value"].get<double>()) << id << "." << name;
      else
        EXPECT_EQ(run.settings.at(name), value) << id << "." << name;
    }
  }
}

TEST(ReplayReader, RejectsEveryParameterOfEveryMethodBeyondItsRange) {
  for (const std::string& id : method_ids())
    for (const auto& parameter : parameter_list(*make_method(id))) {
      const bool ranged = parameter.contains("max");
      const std::string wrong =
          ranged ? std::to_string(parameter["max"].get<double>() + 1) : "'certainly not'";
      const std::string text = std::string(kHead) + "[[method]]\nid = '" + id + "'\n" +
                               parameter["name"].get<std::string>() + " = " + wrong + "\n";
      try {
        read_replay_text(text, "x.toml");
        FAIL() << text;
      } catch (const FileErrors& errors) {
        ASSERT_EQ(errors.diagnostics().size(), 1u);
        EXPECT_EQ(errors.diagnostics()[0].line, 6u);
        EXPECT_NE(errors.diagnostics()[0].message.find(", expected "), std::string::npos);
      }
    }
}

TEST(ReplayReader, RejectsAFractionForEveryIntegerParameter) {
  for (const std::string& id : method_ids())
    for (const auto& parameter : parameter_list(*make_method(id))) {
      if (parameter["type"] != "integer") continue;
      const std::string text = std::string(kHead) + "[[method]]\nid = '" + id + "'\n" +
                               parameter["name"].get<std::string>() + " = " + parameter["value"].dump() +
                               ".0\n";
      EXPECT_THROW(read_replay_text(text, "x.toml"), FileErrors) << text;
    }
}

}  // namespace
}  // namespace plume
