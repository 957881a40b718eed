#include "sandbox/workspace/playback.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

constexpr double kTick = 1.0 / 60.0;

TEST(PlaybackTest, PlaysInRealTimeWhenItIsAskedOften) {
  Playback playback(0, 1000, true);
  for (int ms = 0; ms <= 1000; ++ms) playback.advance(ms * 0.001);
  EXPECT_NEAR(playback.tick(), 60, 2);
}

TEST(PlaybackTest, ShowsEveryTickWhenItIsAskedSeldom) {
  Playback playback(0, 1000, true);
  for (uint32_t frame = 1; frame <= 10; ++frame) {
    EXPECT_TRUE(playback.advance(frame * 0.5));
    EXPECT_EQ(playback.tick(), frame);
  }
}

TEST(PlaybackTest, DoesNotCatchUpWithLostTime) {
  Playback playback(0, 1000, true);
  playback.advance(0);
  playback.advance(100);
  const uint32_t after_the_pause = playback.tick();
  playback.advance(100 + kTick);
  EXPECT_LE(playback.tick(), after_the_pause + 1);
}

TEST(PlaybackTest, SaysHowLongToWait) {
  Playback playback(0, 1000, true);
  playback.advance(10);
  playback.advance(10);
  EXPECT_NEAR(playback.seconds_to_next(10), kTick, 1e-9);
  EXPECT_EQ(playback.seconds_to_next(11), 0);
}

TEST(PlaybackTest, BeginsAnewAfterTheLastTick) {
  Playback playback(7, 7, true);
  EXPECT_TRUE(playback.advance(1));
  EXPECT_EQ(playback.tick(), 0u);
}

TEST(PlaybackTest, DoesNotMoveWhilePaused) {
  Playback playback(5, 10, false);
  EXPECT_FALSE(playback.advance(1));
  playback.toggle();
  EXPECT_TRUE(playback.advance(1));
}

TEST(PlaybackTest, SteppingPausesAndStopsAtTheEnds) {
  Playback playback(1, 2, true);
  playback.step_back();
  EXPECT_FALSE(playback.playing());
  EXPECT_EQ(playback.tick(), 0u);
  playback.step_back();
  EXPECT_EQ(playback.tick(), 0u);
  for (int i = 0; i < 3; ++i) playback.step_forward();
  EXPECT_EQ(playback.tick(), 2u);
}

TEST(PlaybackTest, NeverLeavesTheScene) {
  Playback playback(99, 10, false);
  EXPECT_EQ(playback.tick(), 10u);
  playback.go_to(4);
  playback.go_to(4000);
  EXPECT_EQ(playback.tick(), 10u);
}

TEST(PlaybackTest, WithoutTheLoopItStopsAtTheLastTickAndPlaysAnewFromTheFirst) {
  Playback playback(9, 10, true);
  playback.loops = false;
  EXPECT_TRUE(playback.advance(1));
  EXPECT_FALSE(playback.advance(2));
  EXPECT_FALSE(playback.playing());
  EXPECT_EQ(playback.tick(), 10u);
  playback.toggle();
  EXPECT_EQ(playback.tick(), 0u);
}

TEST(PlaybackTest, PlaysAtTheSpeedThatIsChosen) {
  Playback playback(0, 1000, true);
  playback.speed = 0.25;
  for (int ms = 0; ms <= 1000; ++ms) playback.advance(ms * 0.001);
  EXPECT_NEAR(playback.tick(), 15, 2);
}

}  // namespace
}  // namespace plume
