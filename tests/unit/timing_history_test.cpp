#include "sandbox/measure/timing_history.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

TEST(TimingHistoryTest, HasNoRowsBeforeTheFirstFrame) {
  EXPECT_TRUE(TimingHistory().rows().empty());
}

TEST(TimingHistoryTest, GivesLastAndMedianOfEveryPassAndTheirSum) {
  TimingHistory history;
  for (const double ms : {1.0, 9.0, 2.0}) history.add({{"opaque", ms}, {"draw", 10 * ms}});
  const auto rows = history.rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0].name, "opaque");
  EXPECT_EQ(rows[0].last_ms, 2.0);
  EXPECT_EQ(rows[1].median_ms, 20.0);
  EXPECT_EQ(rows[2].name, "sum");
  EXPECT_EQ(rows[2].last_ms, 22.0);
  EXPECT_EQ(rows[2].median_ms, 22.0);
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
  TimingHistory history;
  history.add({{"step", 4}, {"draw", 1}});
  history.add({{"draw", 1}});
  history.add({{"step", 6}, {"draw", 1}});
  EXPECT_EQ(history.rows()[0].median_ms, 5.0);
}

TEST(TimingHistoryTest, ForgetsWhatIsOlderThanSixtyFrames) {
  TimingHistory history;
  for (int i = 0; i < 60; ++i) history.add({{"draw", 100}});
  for (int i = 0; i < 60; ++i) history.add({{"draw", 1}});
  EXPECT_EQ(history.frames(), 60u);
  EXPECT_EQ(history.rows()[0].median_ms, 1.0);
}

}  // namespace
}  // namespace plume
