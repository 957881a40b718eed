#include "sandbox/workspace/resolution_control.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

/// What a picture takes whose cost goes with its pixels, and some that does not.
double frame_ms(const ResolutionControl& control, double full_ms, double fixed_ms = 0) {
  return fixed_ms + full_ms * control.scale() * control.scale();
}

TEST(ResolutionControlTest, HoldsTheRateWithinAFewFramesAndThenStands) {
  ResolutionControl control;
  control.frames_per_second = 10;
  for (int frame = 0; frame < 3; ++frame) control.learn(frame_ms(control, 900, 5));
  EXPECT_LT(frame_ms(control, 900, 5), 110);
  const double scale = control.scale();
  for (int frame = 0; frame < 100; ++frame) EXPECT_FALSE(control.learn(frame_ms(control, 900, 5)));
  EXPECT_EQ(scale, control.scale());
}

TEST(ResolutionControlTest, GoesUpAgainOnlyWhenThatHoldsToo) {
  ResolutionControl control;
  control.frames_per_second = 10;
  for (int frame = 0; frame < 3; ++frame) control.learn(frame_ms(control, 2000));
  EXPECT_LT(control.scale(), 0.3);
  EXPECT_FALSE(control.learn(1)) << "one lucky frame";
  for (int frame = 0; frame < 100; ++frame) control.learn(frame_ms(control, 150));
  EXPECT_EQ(0.75, control.scale()) << "84 ms; the whole would take 150";
}

TEST(ResolutionControlTest, IsWholeAtRestAndWhereItWasWhenThingsMoveAgain) {
  ResolutionControl control;
  EXPECT_FALSE(control.rest()) << "it is whole already";
  control.move();
  for (int frame = 0; frame < 3; ++frame) control.learn(frame_ms(control, 900));
  const size_t step = control.step();
  ASSERT_GT(step, 0u);
  EXPECT_TRUE(control.rest());
  EXPECT_EQ(1.0, control.scale());
  EXPECT_EQ(glm::uvec2(640, 360), control.picture_size({640, 360}));
  EXPECT_FALSE(control.rest()) << "it rests already";
  control.move();
  EXPECT_EQ(ResolutionControl::kScales[step], control.scale());
  ASSERT_TRUE(control.rest());
  control.adapts = false;
  EXPECT_EQ(ResolutionControl::kScales[step], control.scale()) << "chosen, and not to be changed";
  control.move();
  EXPECT_FALSE(control.rest());
}

TEST(ResolutionControlTest, StopsAtTheCoarsestAndStandsWhenItDoesNotAdapt) {
  ResolutionControl control;
  for (int frame = 0; frame < 20; ++frame) control.learn(1e6);
  EXPECT_EQ(ResolutionControl::kScales.back(), control.scale());
  EXPECT_EQ(glm::uvec2(1), control.picture_size({3, 1})) << "never nothing";
  control.adapts = false;
  control.set_step(0);
  EXPECT_FALSE(control.learn(1e6));
  EXPECT_EQ(1.0, control.scale());
}

}  // namespace
}  // namespace plume
