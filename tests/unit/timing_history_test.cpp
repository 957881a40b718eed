#include "sandbox/measure/timing_history.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

TEST(TimingHistoryTest, HasNoRowsBeforeTheFirstFrame) {
  EXPECT_TRUE(TimingHistory().rows().empty());
}

/// With frames before, which come after every change and do not count.
TimingHistory after_a_change() {
  TimingHistory history;
  for (size_t i = 0; i < TimingHistory::kDropped; ++i) history.add({{"draw", 1e6}});
  return history;
}

TEST(TimingHistoryTest, GivesLastMedianAndPercentileOfEveryPassAndTheirSum) {
  TimingHistory history = after_a_change();
  for (const double ms : {1.0, 9.0, 2.0}) history.add({{"opaque", ms}, {"draw", 10 * ms}});
  const auto rows = history.rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].name, "opaque");
  EXPECT_EQ(rows[0].last_ms, 2.0);
  EXPECT_NEAR(rows[0].p95_ms, 8.3, 1e-9) << "between 2 and 9";
  EXPECT_EQ(rows[2].name, "sum");
  EXPECT_EQ(rows[2].last_ms, 22.0);
}

TEST(TimingHistoryTest, DropsTheFramesAfterAChangeButShowsThemUntilBetterOnesCome) {
  TimingHistory history;
  history.add({{"draw", 100}});
  EXPECT_EQ(history.rows()[0].median_ms, 100);
  history.add({{"draw", 50}});
  for (const double ms : {1.0, 3.0, 2.0}) history.add({{"draw", ms}});
  EXPECT_EQ(history.rows()[0].median_ms, 2);
  history.clear();
  EXPECT_EQ(history.frames(), 0u);
}

TEST(TimingHistoryTest, AddsUpPassesOfOneName) {
  TimingHistory history;
  history.add({{"scan", 1}, {"draw", 5}, {"scan", 2}});
  const auto rows = history.rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].last_ms, 3.0);
  EXPECT_EQ(rows[2].last_ms, 8.0);
}

TEST(TimingHistoryTest, MedianIsOverFramesThatHadThePass) {
  TimingHistory history = after_a_change();
  history.add({{"step", 4}, {"draw", 1}});
  history.add({{"draw", 1}});
  history.add({{"step", 6}, {"draw", 1}});
  EXPECT_EQ(history.rows()[0].median_ms, 5.0);
}

TEST(TimingHistoryTest, ForgetsWhatIsOlderThanItsLength) {
  TimingHistory history;
  for (size_t i = 0; i < TimingHistory::kFrames; ++i) history.add({{"draw", 100}});
  for (size_t i = 0; i < TimingHistory::kFrames; ++i) history.add({{"draw", 1}});
  EXPECT_EQ(history.frames(), TimingHistory::kFrames);
  EXPECT_EQ(history.rows()[0].median_ms, 1.0);
}

TEST(TimingHistoryTest, AddsUpGroupsFrameByFrame) {
  TimingHistory history = after_a_change();
  history.add({{"cards", 1}, {"splat", 2}, {"opaque", 4}, {"draw", 8}, {"display", 16}, {"unheard of", 32}});
  EXPECT_EQ(history.groups().back(), (TimingHistory::Groups{1, 2, 12, 16, 32}));
}

TEST(TimingHistoryTest, ExportsALineAFrameWithGapsWhereAPassWasNot) {
  TimingHistory history;
  history.add({{"draw", 9}}), history.add({{"draw", 9}});  // dropped
  history.add({{"draw", 1.5}});
  history.add({{"step", 2}, {"draw", 0.25}});
  EXPECT_EQ(history.csv(), "frame,draw ms,sum ms,step ms\n0,1.5000,1.5000,\n1,0.2500,2.2500,2.0000\n");
  EXPECT_NE(history.json().find("\"group\": \"draws\""), std::string::npos);
}

}  // namespace
}  // namespace plume
