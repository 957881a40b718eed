// Machines that fail: no device, a lost one, too little memory. The message says what, and what was finished
// stays.
#include "tests/command/program.h"

namespace plume {
namespace {

class FailureTest : public ProgramTest {
 protected:
  void expect_failure(const Outcome& outcome, int exit_code, const std::vector<std::string>& parts) {
    EXPECT_EQ(outcome.exit_code, exit_code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_TRUE(says(outcome.err, parts));
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
