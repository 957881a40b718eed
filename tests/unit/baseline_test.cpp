#include "sandbox/runs/baseline.h"

#include <gtest/gtest.h>

#include <limits>

namespace plume {
namespace {

Summary about(double ms, double reach, size_t samples = 9) {
  return {.median = ms, .low = ms - reach, .high = ms + reach, .samples = samples};
}

FrameResult drawn(const std::string& method, double rmse, Summary own) {
  FrameResult frame{.scene = "street", .tick = 400, .width = 640, .height = 360, .method = method};
  frame.error = ErrorSummary{.rmse = rmse, .flip = rmse};
  frame.transparency_ms = own;
  return frame;
}

/// `reference` took 600 ms, two methods a tenth and a fifth of it.
Results earlier() {
  return {.environment = {{"device", "a"}, {"cpu", "c"}},
          .frames = {drawn("reference", 0.0, about(600, 6)), drawn("wboit", 0.15, about(60, 1)),
                     drawn("avboit", 0.01, about(120, 1))}};
}

BaselineVerdict verdict_of(const Results& run, const Results& baseline = earlier(),
                           const Tolerances& tolerances = {}) {
  return against_baseline(baseline, run, tolerances);
}

TEST(BaselineTest, TheSameAgainIsNeitherWorseNorBetter) {
  const BaselineVerdict verdict = verdict_of(earlier());
  EXPECT_TRUE(verdict.passed());
  EXPECT_EQ(verdict.compared, 3u);
  EXPECT_TRUE(verdict.better.empty() && verdict.added.empty() && verdict.notes.empty());
}

TEST(BaselineTest, AnErrorBeyondItsToleranceIsWorse) {
  Results run = earlier();
  run.frames[2].error->rmse = 0.0104;  // 4 %
  EXPECT_TRUE(verdict_of(run).passed());
  run.frames[2].error->rmse = 0.0107;
  const BaselineVerdict verdict = verdict_of(run);
  EXPECT_FALSE(verdict.passed());
  ASSERT_EQ(verdict.worse.size(), 1u);
  EXPECT_EQ(verdict.worse[0].job, "street tick 400 640x360 seed 0 avboit");
  EXPECT_EQ(verdict.worse[0].what, "RMSE");
  EXPECT_EQ(verdict.worse[0].before, "0.01000");
  EXPECT_EQ(verdict.worse[0].after, "0.01070");
  run.frames[2].error = earlier().frames[2].error;
  run.frames[2].error->flip = 0.02;
  EXPECT_EQ(verdict_of(run).worse.at(0).what, "FLIP");
}

TEST(BaselineTest, AnErrorFromNothingToNearlyNothingIsTheSame) {
  Results run = earlier();
  run.frames[0].error->rmse = 1e-7;
  EXPECT_TRUE(verdict_of(run).passed());
  run.frames[0].error->rmse = 1e-3;
  EXPECT_FALSE(verdict_of(run).passed());
}

TEST(BaselineTest, APictureThatHasANanNowIsWorseAndOneThatHadOneIsNot) {
  const double inf = std::numeric_limits<double>::infinity();
  Results broken = earlier();
  broken.frames[1].error->rmse = inf;
  EXPECT_FALSE(verdict_of(broken).passed());
  EXPECT_TRUE(verdict_of(broken, broken).passed());
  EXPECT_EQ(verdict_of(earlier(), broken).better.size(), 1u);
}

TEST(BaselineTest, TimesCompareAsRatiosToTheReference) {
  Results slow_machine = earlier();  // three times as slow in everything
  for (FrameResult& frame : slow_machine.frames)
    frame.transparency_ms = about(3 * frame.transparency_ms.median, 2);
  EXPECT_TRUE(verdict_of(slow_machine).passed());
  Results run = earlier();
  run.frames[2].transparency_ms = about(150, 1);
  const BaselineVerdict verdict = verdict_of(run);
  ASSERT_EQ(verdict.worse.size(), 1u);
  EXPECT_EQ(verdict.worse[0].what, "own time");
  EXPECT_TRUE(verdict.worse[0].before.starts_with("0.2000 of reference's")) << verdict.worse[0].before;
  EXPECT_TRUE(verdict.worse[0].after.starts_with("0.2500 of reference's")) << verdict.worse[0].after;
  EXPECT_EQ(verdict_of(earlier(), run).better.size(), 1u);
}

TEST(BaselineTest, ATimeIsWorseOnlyWhenTheIntervalsDoNotMeet) {
  Results run = earlier();
  run.frames[2].transparency_ms = about(150, 30);
  EXPECT_TRUE(verdict_of(run).passed());
  run.frames[2].transparency_ms = about(150, 1);
  run.frames[0].transparency_ms = about(600, 200);  // the ruler is as doubtful
  EXPECT_TRUE(verdict_of(run).passed());
}

TEST(BaselineTest, FewRepetitionsTellNothingOfTimesAndThatIsSaid) {
  Results run = earlier();
  for (FrameResult& frame : run.frames) frame.transparency_ms = about(500, 0, 3);
  const BaselineVerdict verdict = verdict_of(run);
  EXPECT_TRUE(verdict.passed());
  EXPECT_EQ(verdict.notes,
            std::vector<std::string>{"times of 2 jobs have fewer than 4 repetitions, which tell nothing"});
}

TEST(BaselineTest, AMissingJobFailsAndANewOneIsNamed) {
  Results run = earlier();
  run.frames.pop_back();
  run.frames.push_back(drawn("sorted", 0.0, about(55, 1)));
  const BaselineVerdict verdict = verdict_of(run);
  EXPECT_FALSE(verdict.passed());
  EXPECT_EQ(verdict.missing, std::vector<std::string>{"street tick 400 640x360 seed 0 avboit"});
  EXPECT_EQ(verdict.added, std::vector<std::string>{"street tick 400 640x360 seed 0 sorted"});
}

TEST(BaselineTest, AJobThatDrawsNoMoreIsWorse) {
  Results run = earlier();
  run.frames[1].status = "unavailable: needs magic";
  EXPECT_EQ(verdict_of(run).worse.at(0).after, "unavailable: needs magic");
  EXPECT_EQ(verdict_of(earlier(), run).better.size(), 1u);
  EXPECT_TRUE(verdict_of(run, run).passed());
}

TEST(BaselineTest, OtherMomentsAndSettingsAreOtherJobs) {
  for (const auto& change : {+[](FrameResult& f) { f.tick = 1; }, +[](FrameResult& f) { f.scene = "x"; },
                             +[](FrameResult& f) { f.shot = 1; }, +[](FrameResult& f) { f.seed = 1; },
                             +[](FrameResult& f) { f.width = 1; }, +[](FrameResult& f) { f.height = 1; },
                             +[](FrameResult& f) {
                               f.settings = {{"weight", "eq10"}};
                             }}) {
    Results run = earlier();
    change(run.frames[1]);
    EXPECT_EQ(verdict_of(run).missing.size(), 1u);
    EXPECT_EQ(verdict_of(run).added.size(), 1u);
  }
}

TEST(BaselineTest, AParameterThatTheBaselineDidNotKnowIsNoOtherJobAtItsDefault) {
  Results run = earlier();
  run.frames[1].settings = {{"weight", "eq7"}};  // the default
  EXPECT_TRUE(verdict_of(run).passed());
  EXPECT_FALSE(verdict_of(earlier(), run).passed());  // and now it is gone
  run.frames[1].settings = {{"weight", "eq8"}};
  EXPECT_FALSE(verdict_of(run).passed());
}

TEST(BaselineTest, OnAnotherDeviceErrorsAreComparedAlone) {
  Results run = earlier();
  run.environment["device"] = "b";
  run.frames[2].transparency_ms = about(500, 1);
  BaselineVerdict verdict = verdict_of(run);
  EXPECT_TRUE(verdict.passed());
  EXPECT_EQ(verdict.notes.size(), 1u);
  run.frames[2].error->rmse = 0.02;
  EXPECT_FALSE(verdict_of(run).passed());
}

TEST(BaselineTest, ABaselineWithoutRatiosIsRefusedWithTheRemedy) {
  Results baseline = earlier();
  EXPECT_NO_THROW(require_ratios(baseline, {}));
  baseline.frames.erase(baseline.frames.begin());
  EXPECT_NO_THROW(require_ratios(baseline, {.time = {}}));
  try {
    require_ratios(baseline, {});
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("no time of `reference` at street tick 400"), std::string::npos)
        << error.what();
    EXPECT_NE(std::string(error.what()).find("--tolerance-time off"), std::string::npos);
  }
}

TEST(BaselineTest, TextNamesEveryFinding) {
  Results run = earlier();
  run.frames[2].error->rmse = 0.02;
  run.frames.erase(run.frames.begin() + 1);
  EXPECT_EQ(to_text(verdict_of(run), "old.json"),
            "against old.json: 2 jobs compared, 1 worse, 0 better, 1 missing, 0 new\n"
            "  worse   street tick 400 640x360 seed 0 avboit: RMSE 0.01000 -> 0.02000\n"
            "  missing street tick 400 640x360 seed 0 wboit\n");
}

}  // namespace
}  // namespace plume
