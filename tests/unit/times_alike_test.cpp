#include "sandbox/runs/times_alike.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

/// Of a method that took about `ms`, give or take `reach`.
FrameResult took(const std::string& method, double ms, double reach, size_t samples = 9) {
  FrameResult frame{.scene = "street", .tick = 400, .method = method};
  frame.transparency_ms = {.median = ms, .low = ms - reach, .high = ms + reach, .samples = samples};
  return frame;
}

TEST(TimesAlikeTest, NamesNeighboursWhoseIntervalsMeet) {
  const Results results{.frames = {took("sorted", 50, 2), took("avboit", 127, 3), took("wboit", 53, 2),
                                   took("vboit", 128, 3), took("coloured", 56, 2)}};
  EXPECT_EQ(times_alike(results),
            "own ms not told apart, street tick 400: sorted ~ wboit ~ coloured, avboit ~ vboit\n");
}

TEST(TimesAlikeTest, SaysNothingWhereAllAreApart) {
  EXPECT_EQ(times_alike({.frames = {took("sorted", 50, 2), took("avboit", 127, 3)}}), "");
  EXPECT_EQ(times_alike({}), "");
}

TEST(TimesAlikeTest, SaysThatTooFewRepetitionsTellNothing) {
  EXPECT_EQ(times_alike({.frames = {took("sorted", 50, 2, 3), took("avboit", 127, 3, 3)}}),
            "own ms not told apart, street tick 400: all, with 3 of the 4 repetitions that it takes\n");
}

TEST(TimesAlikeTest, KeepsMomentsApart) {
  Results results{.frames = {took("sorted", 50, 2), took("avboit", 51, 3)}};
  results.frames[1].tick = 401;
  EXPECT_EQ(times_alike(results), "");
}

TEST(TimesAlikeTest, TellsSettingsOfOneMethodApartByName) {
  Results results{.frames = {took("wboit", 50, 2), took("wboit", 51, 2)}};
  results.frames[1].settings = {{"weight", "eq10"}};
  EXPECT_EQ(times_alike(results), "own ms not told apart, street tick 400: wboit ~ wboit weight=eq10\n");
}

}  // namespace
}  // namespace plume
