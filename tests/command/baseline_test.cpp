// plume compare --baseline: a run held against an earlier one.
#include <functional>

#include "tests/command/program.h"

namespace plume {
namespace {

class BaselineRunTest : public ProgramTest {
 protected:
  Outcome compare(const Arguments& more) {
    Arguments arguments{"compare", "quads_mcguire", "--size", "16x9", "--frames", "4"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  void SetUp() override {
    ProgramTest::SetUp();
    ASSERT_EQ(compare({"--methods", "reference,wboit", "--out", "before"}).exit_code, 0);
  }
  /// The same again, against the first run as `edit` leaves its second frame, which is wboit's.
  Outcome compare_against(const std::function<void(json& wboit)>& edit, const Arguments& more = {}) {
    json baseline = results("before");
    edit(baseline["frames"][1]);
    write("baseline.json", baseline.dump());
    Arguments arguments{"--methods", "reference,wboit", "--baseline", "baseline.json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return compare(arguments);
  }
};

const auto kAsItWas = [](json&) {};
/// Of times that other programs on the machine may stretch.
const Arguments kAnyTime{"--tolerance-time", "1000"};

TEST_F(BaselineRunTest, TheSameAgainPasses) {
  const Outcome outcome = compare_against(kAsItWas, kAnyTime);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(
      says(outcome.out, {"against baseline.json: 2 jobs compared, 0 worse, 0 better, 0 missing, 0 new"}));
}

TEST_F(BaselineRunTest, AnErrorThatGrewFails) {
  const auto was_exact = [](json& wboit) { wboit["error"]["rmse"] = 0.0; };
  const Outcome outcome = compare_against(was_exact, kAnyTime);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(
      says(outcome.out, {"1 worse", "worse   quads_mcguire tick 0 16x9 seed", "wboit: RMSE 0.00000 -> "}));
}

TEST_F(BaselineRunTest, ATimeThatGrewBeyondDoubtFails) {
  const auto was_fast = [](json& wboit) {
    wboit["transparency_ms"] = 1e-6;
    wboit["transparency_ms_interval"] = {1e-6, 1e-6};
  };
  const Outcome outcome = compare_against(was_fast);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(says(outcome.out, {"wboit: own time 0.0000 of reference's"}));
  EXPECT_EQ(compare_against(was_fast, {"--tolerance-time", "off"}).exit_code, 0);
}

TEST_F(BaselineRunTest, AJobThatIsNotDrawnFailsAndANewOneIsNamed) {
  const auto was_eq10 = [](json& wboit) { wboit["settings"]["weight"] = "eq10"; };
  const Outcome outcome = compare_against(was_eq10, kAnyTime);
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(says(outcome.out, {"missing quads_mcguire", "wboit weight=eq10", "new     quads_mcguire"}));
}

TEST_F(BaselineRunTest, WhatCannotBeComparedIsRefusedBeforeAnythingIsDrawn) {
  const auto refused = [&](const Arguments& arguments, const std::vector<std::string>& parts) {
    const Outcome outcome = compare(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_TRUE(says(outcome.err, parts));
    EXPECT_FALSE(fs::exists(at("out")));
  };
  const std::string before = "before/results.json";
  refused({"--methods", "wboit", "--baseline", before}, {"does not draw", "--tolerance-time off"});
  refused({"--methods", "reference", "--baseline", before, "--shard", "0/2"}, {"only a part"});
  refused({"--methods", "reference", "--baseline", "nowhere.json"}, {"nowhere.json: No such file"});
  refused({"--methods", "reference", "--baseline", before, "--tolerance-error", "0.5"},
          {"--tolerance-error 0.5: expected a factor of at least 1"});
  json without = results("before");
  without["frames"].erase(0);
  write("without.json", without.dump());
  refused({"--methods", "reference,wboit", "--baseline", "without.json"},
          {"no time of `reference` at quads_mcguire", "draw the baseline again"});
}

TEST_F(BaselineRunTest, JsonStaysAloneOnStandardOutput) {
  const Outcome outcome = compare_against(kAsItWas, {"--tolerance-time", "1000", "--json"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_TRUE(json::accept(outcome.out));
  EXPECT_TRUE(says(outcome.err, {"against baseline.json"}));
}

}  // namespace
}  // namespace plume
