#include "sandbox/workspace/view_words.h"

#include <gtest/gtest.h>

#include <cmath>

namespace plume {
namespace {

Inspected seen(Inspection what, std::vector<float> values) {
  const int width = int(values.size());
  return {.what = std::move(what),
          .slice = 1,
          .values = {width, 1, std::move(values)},
          .slices = {{2, 3, 7}, {3, 4.5f, 8}, {9, 10, 20}},
          .report = {}};
}

TEST(ViewWordsTest, APixelIsItsNumberItsClassOrWhatItLacks) {
  const Inspected overdraw =
      seen({.id = "o", .title = "Overdraw", .help = "", .unit = "fragments", .absent = "no fragment"},
           {34, NAN, INFINITY});
  EXPECT_EQ(pixel_words(overdraw, 0, 0), "34 fragments");
  EXPECT_EQ(pixel_words(overdraw, 1, 0), "no fragment");
  EXPECT_EQ(pixel_words(overdraw, 2, 0), "infinite");
  const Inspected classes =
      seen({.id = "c", .title = "", .help = "", .unit = "", .absent = "empty", .classes = {"one", "both"}},
           {1, 2, NAN});
  EXPECT_EQ(pixel_words(classes, 0, 0), "one");
  EXPECT_EQ(pixel_words(classes, 1, 0), "both");
  EXPECT_EQ(pixel_words(classes, 2, 0), "empty");
}

TEST(ViewWordsTest, AColumnOfAChartIsItsSliceWhateverTheRow) {
  const Inspected chart =
      seen({.id = "m", .title = "", .help = "", .unit = "virtual slice", .over_slices = true},
           {NAN, 7, 8, 8, 20, 20});
  EXPECT_EQ(pixel_words(chart, 0, 0), "physical slice 0 of 3 is virtual slice 7\n2 to 3 m");
  EXPECT_EQ(pixel_words(chart, 3, 0), "physical slice 1 of 3 is virtual slice 8\n3 to 4.5 m");
  EXPECT_EQ(pixel_words(chart, 5, 0), "physical slice 2 of 3 is virtual slice 20\n9 to 10 m");
}

TEST(ViewWordsTest, ASliceIsWhereItLiesOrNotInUse) {
  Inspected slice = seen({.id = "s", .title = "", .help = "", .unit = "", .slices = 64}, {1});
  EXPECT_EQ(slice_words(slice), "slice 1 of 3: 3 to 4.5 m, virtual slice 8");
  slice.slice = 9;
  EXPECT_EQ(slice_words(slice), "slice 9: not in use, 3 are");
  slice.what.slices = 0;
  EXPECT_EQ(slice_words(slice), "");
}

TEST(ViewWordsTest, TheScaleSaysWhereItsRangeComesFrom) {
  SideView view;
  view.shown = seen({.id = "f", .title = "", .help = "", .unit = "", .range = glm::vec2(0, 1)}, {0.5f});
  view.scale = {0, 1, false};
  view.range = SideView::Range::kWhole;
  EXPECT_EQ(scale_words(view), "linear, 0 to 1: all it can be");
  view.range = SideView::Range::kFound;
  view.scale = {0.25f, 8, true};
  EXPECT_EQ(scale_words(view), "log, 0.25 to 8: what is in this picture");
  view.shares_scale = true;
  EXPECT_EQ(scale_words(view), "log, 0.25 to 8: what is in both pictures");
  view.range = SideView::Range::kHeld;
  EXPECT_EQ(scale_words(view), "log, 0.25 to 8: held");
}

TEST(ViewWordsTest, EndsOfTheBarSayThatThereIsMoreBeyond) {
  SideView view;
  view.scale = {1, 5, false};
  view.found = {.least = 1, .most = 5, .count = 2};
  EXPECT_EQ(bar_number(view, 0), "1");
  EXPECT_EQ(bar_number(view, 1), "5");
  view.found = {.least = 0, .most = 9, .count = 2};
  EXPECT_EQ(bar_number(view, 0), "<=1");
  EXPECT_EQ(bar_number(view, 0.5f), "3");
  EXPECT_EQ(bar_number(view, 1), ">=5");
}

}  // namespace
}  // namespace plume
