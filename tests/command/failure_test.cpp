// Machines that fail: no device, a lost one, one that lacks a feature, too little memory. The message says
// what, and what was finished stays.
#include <set>

#include "renderer/gpu/device.h"
#include "sandbox/measure/image_io.h"
#include "sandbox/runs/without_times.h"
#include "tests/command/program.h"
#include "tests/faults/every.h"

namespace plume {
namespace {

class FailureTest : public ProgramTest {
 protected:
  void expect_failure(const Outcome& outcome, int exit_code, const std::vector<std::string>& parts) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(says(outcome.err, parts));
  }

  /// A replay whose device fails at its first submission, at its second (KIND@1, KIND@2) and so on to its
  /// end, each of which --resume goes on from. How many there were; those of `stride` were tried.
  uint64_t fail_at_each(const std::string& kind, const std::vector<std::string>& parts, uint64_t stride) {
    write("script.toml", street_script("[20, 40]", "[[method]]\nid = 'avboit'\n"));
    EXPECT_EQ(run({"replay", "script.toml", "--out", "whole"}).exit_code, 0);
    for (uint64_t at = 1;; at += stride) {
      SCOPED_TRACE(kind + " " + std::to_string(at));
      fs::remove_all(this->at("out"));
      const Outcome failed =
          run({"replay", "script.toml"}, {{"PLUME_FAULT", kind + "@" + std::to_string(at)}});
      if (failed.exit_code == 0) return at;
      expect_failure(failed, 4, parts);
      for (const std::string& file : fs::exists(this->at("out")) ? files() : std::vector<std::string>())
        if (file.ends_with(".png"))
          EXPECT_EQ(read("out/" + file), read("whole/" + file)) << file;
        else
          EXPECT_TRUE(file == "results.json" || file == "results.csv") << file;
      EXPECT_EQ(run({"replay", "script.toml", "--resume"}).exit_code, 0);
      EXPECT_EQ(without_times(results()), without_times(results("whole")));
      EXPECT_EQ(pictures(), pictures("whole"));
      if (HasFailure()) return at;
    }
  }
};

TEST_F(FailureTest, UnknownDeviceNamesThoseThereAre) {
  const json devices = json::parse(run({"list", "devices", "--json"}).out);
  expect_failure(run(compare_quickly("quads_mcguire", {"--device", "voodoo"})), 3,
                 {"no device matches 'voodoo'", devices[0]["title"]});
  expect_failure(run(compare_quickly("quads_mcguire", {"--device", "99"})), 3, {"'99'", devices[0]["title"]});
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(FailureTest, DeviceIsChosenByIndexOrPartOfItsName) {
  const json device = json::parse(run({"list", "devices", "--json"}).out)[0];
  for (const std::string& choice :
       {device["id"].get<std::string>(), device["title"].get<std::string>().substr(1, 4)}) {
    const Outcome outcome =
        run(compare_quickly("quads_mcguire", {"--methods", "sorted", "--device", choice}));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(results()["environment"]["device"], device["title"]);
  }
}

TEST_F(FailureTest, MissingDriverComesWithARemedy) {
  expect_failure(run(compare_quickly("street"), {{"VK_ICD_FILENAMES", "/nonexistent"}}), 3,
                 {"Vulkan", "install a driver", "mesa-vulkan-drivers"});
}

TEST_F(FailureTest, MissingValidationLayerComesWithARemedy) {
  expect_failure(run(compare_quickly("street", {"--validate"}), {{"VK_LAYER_PATH", at("none").string()}}), 3,
                 {"VK_LAYER_KHRONOS_validation", "install the package vulkan-validationlayers"});
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(FailureTest, EveryFeatureThatIsRequiredIsNamedWhereItIsMissing) {
  for (const gpu::DeviceNeed& need : gpu::device_needs()) {
    if (!need.required) continue;
    expect_failure(run(compare_quickly("street"), {{"PLUME_FAULT", std::string("missing@") + need.name}}), 3,
                   {"misses: ", need.name});
    EXPECT_FALSE(fs::exists(at("out")));
  }
}

TEST_F(FailureTest, WithoutAnOptionalFeatureMethodsThatNeedItAreNamedAndAllOthersGoOn) {
  std::set<std::map<std::string, std::string>> seen;  // what goes without two of them is often the same
  const auto unavailable_with = [&](const Environment& environment) {
    std::map<std::string, std::string> unavailable;
    for (const json& method : json::parse(run({"list", "methods", "--json"}, environment).out))
      for (const std::string name : method["missing"]) {
        std::string& names = unavailable[method["id"]];
        names += (names.empty() ? "" : ", ") + name;
      }
    return unavailable;
  };
  const auto as_it_is = unavailable_with({});
  for (const gpu::DeviceNeed& need : gpu::device_needs()) {
    if (need.required) continue;
    SCOPED_TRACE(need.name);
    const Environment without{{"PLUME_FAULT", std::string("missing@") + need.name}};
    const std::map<std::string, std::string> unavailable = unavailable_with(without);
    if (!seen.insert(unavailable).second) continue;
    if (std::string_view(need.name).substr(0, 3) != "VK_")
      for (const auto& [id, names] : unavailable) {
        EXPECT_TRUE(as_it_is.contains(id) || says(names, {need.name})) << id;
      }
    const std::string listed = run({"list", "methods"}, without).out;
    const Outcome compared =
        run(compare_quickly("quads_mcguire", {"--methods", "all", "--validate"}), without);
    const Outcome stressed = run({"stress", "three_cards", "--json"}, without);
    ASSERT_EQ(compared.exit_code, 0) << compared.err;
    ASSERT_LE(stressed.exit_code, 1) << stressed.err;
    for (const json& frame : frames()) {
      const auto lacks = unavailable.find(frame["method"]);
      EXPECT_EQ(frame["status"], lacks == unavailable.end() ? "ok" : "unavailable: needs " + lacks->second);
    }
    for (const json& row : json(json::parse(stressed.out)["rows"])) {
      EXPECT_EQ(row["verdict"] == "unavailable", unavailable.contains(row["method"])) << row;
      EXPECT_NE(row["verdict"], "FAILED") << row;
    }
    for (const auto& [id, names] : unavailable) {
      EXPECT_TRUE(says(listed, {"unavailable: needs " + names}));
      EXPECT_TRUE(says(compared.out, {"unavailable: needs " + names}));
      expect_failure(run({"inspect", "quads_mcguire", "--method", id, "--view", "overdraw"}, without), 3,
                     {names});
    }
    fs::remove_all(at("out"));
  }
  EXPECT_GE(seen.size(), 2u);  // or nothing was missing in any of them
}

TEST_F(FailureTest, ADeviceLostAtAnySubmissionIsGoneOnFrom) {
  // 49 is the last of the first tick on lavapipe: its frame is drawn, its moment not yet known.
  EXPECT_GT(fail_at_each("device_lost", {"the device was lost", "the last pass was '"}, every(24)), 60u);
}

TEST_F(FailureTest, AnAllocationThatFindsNoRoomIsNamedAndGoneOnFrom) {
  EXPECT_GT(fail_at_each("no_room", {"out of device memory: ", " needs ", " bytes"}, every(61)), 60u);
}

TEST_F(FailureTest, LostDeviceNamesThePass) {
  expect_failure(run(compare_quickly("street"), {{"PLUME_FAULT", "device_lost@draw"}}), 4,
                 {"the device was lost", "'draw'"});
}

TEST_F(FailureTest, LackOfMemoryNamesThePass) {
  expect_failure(run(compare_quickly("street"), {{"PLUME_FAULT", "out_of_memory@draw"}}), 4,
                 {"out of device memory", "'draw'"});
}

TEST_F(FailureTest, MemoryLimitNamesWhatDidNotFit) {
  const Outcome outcome =
      run({"compare", "street", "--size", "1920x1080", "--frames", "1", "--memory-limit", "8"});
  expect_failure(outcome, 4,
                 {"out of device memory", "frame.opaque_color needs 16588800 bytes", "limit of 8388608"});
}

TEST_F(FailureTest, LostTickLeavesNothingUnderAFinalName) {
  write("script.toml", street_script("[20, 40]", "[[method]]\nid = 'sorted'\n[[method]]\nid = 'avboit'\n"));
  expect_failure(run({"replay", "script.toml"}, {{"PLUME_FAULT", "device_lost@integrate"}}), 4,
                 {"'integrate'"});
  EXPECT_EQ(files(), (std::vector<std::string>{"results.csv", "results.json"}));
  EXPECT_EQ(results()["frames"], json::array());
}

TEST_F(FailureTest, FinishedFramesSurviveALaterLoss) {
  write("first.toml", street_script("[20, 40]", "[[method]]\nid = 'sorted'\n"));
  write("second.toml", street_script("[20, 40]", "[[method]]\nid = 'avboit'\n"));
  const Arguments both{"replay", "first.toml", "second.toml"};
  const Environment fault{{"PLUME_FAULT", "device_lost@integrate"}};
  expect_failure(run(both, fault), 4, {"[1/4]", "[2/4]", "'integrate'"});
  ASSERT_EQ(results()["frames"].size(), 2u);
  EXPECT_EQ(files(), (std::vector<std::string>{"results.csv", "results.json", "street_000020_sorted.png",
                                               "street_000020_sorted_error.png", "street_000040_sorted.png",
                                               "street_000040_sorted_error.png"}));
  const json before = results()["frames"];
  const auto drawn = pictures();

  const Outcome resumed = run({"replay", "first.toml", "second.toml", "--resume"});
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  const json after = results()["frames"];
  ASSERT_EQ(after.size(), 4u);
  EXPECT_EQ(after[0], before[0]);
  EXPECT_EQ(after[1], before[1]);
  EXPECT_EQ(pictures().size(), 8u);
  for (const auto& [name, bytes] : drawn) EXPECT_EQ(pictures().at(name), bytes) << name;
}

}  // namespace
}  // namespace plume
