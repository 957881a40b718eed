#include "sandbox/workspace/instance_switches.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

using Silent = std::set<size_t>;

TEST(InstanceSwitches, SoloSilencesAllOthersAndWhatIsMutedStaysSo) {
  InstanceSwitches switches;
  EXPECT_EQ(switches.silent(4), Silent());
  switches.muted = {1};
  EXPECT_EQ(switches.silent(4), (Silent{1}));
  switches.solo = {1, 2};
  EXPECT_EQ(switches.silent(4), (Silent{0, 1, 3}));
  switches.muted.clear();
  EXPECT_EQ(switches.silent(4), (Silent{0, 3}));
  switches.solo.clear();
  EXPECT_EQ(switches.silent(4), Silent());
}

TEST(InstanceSwitches, FollowTheirInstancesWhereOthersComeAndGo) {
  const InstanceSwitches switches{.muted = {0, 2}, .solo = {1}, .frozen = {{2, 40}, {1, 7}}};
  const InstanceSwitches moved = switches.renumbered({3, {}, 0});
  EXPECT_EQ(moved, (InstanceSwitches{.muted = {0, 3}, .solo = {}, .frozen = {{0, 40}}}));
}

}  // namespace
}  // namespace plume
