// The time of an instance, against a list of every tick at which it stood still.
#include "sandbox/effects/clock.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

namespace plume {
namespace {

/// Ticks that are far less than UINT32_MAX.
class TickByTick {
 public:
  explicit TickByTick(uint32_t call_tick) : call_tick_(call_tick) {}
  std::optional<uint32_t> local(uint32_t tick) const {
    if (tick < call_tick_) return {};
    uint32_t passed = 0;
    for (uint32_t t = call_tick_ + 1; t <= tick; ++t) passed += !standing_.contains(t);
    return passed;
  }
  bool stood_still(uint32_t tick) const { return standing_.contains(tick); }
  void stand_still(uint32_t first, uint32_t end) {
    for (uint32_t t = first; t < end; ++t) standing_.insert(t);
  }
  void forget_from(uint32_t tick) { standing_.erase(standing_.lower_bound(tick), standing_.end()); }

 private:
  uint32_t call_tick_;
  std::set<uint32_t> standing_;
};

TEST(Clock, TellsTheTimeThatAListOfEveryTickTells) {
  constexpr uint32_t kLast = 60;
  std::mt19937 random(1);
  for (int run = 0; run < 200; ++run) {
    const uint32_t call_tick = uint32_t(random() % 20);
    Clock clock(call_tick);
    TickByTick expected(call_tick);
    for (int change = 0; change < 8; ++change) {
      const uint32_t first = uint32_t(random() % 50), end = first + uint32_t(random() % 10);
      switch (random() % 4) {
        case 0:
          clock.forget_from(first), expected.forget_from(first);
          break;
        case 1:
          clock.freeze({first, end}), expected.stand_still(first + 1, end + 1);
          break;
        default:
          clock.stand_still(first, end), expected.stand_still(first, end);
      }
      for (uint32_t tick = 0; tick <= kLast; ++tick) {
        ASSERT_EQ(expected.local(tick), clock.local(tick)) << "run " << run << ", tick " << tick;
        ASSERT_EQ(expected.stood_still(tick), clock.stood_still(tick)) << "run " << run << ", tick " << tick;
      }
    }
  }
}

TEST(Clock, StandsStillForGoodAtTheLastTickOfAll) {
  Clock clock(10);
  clock.freeze({20, UINT32_MAX - 1});
  EXPECT_EQ(10u, clock.local(20));
  EXPECT_EQ(10u, clock.local(UINT32_MAX - 1));
}

}  // namespace
}  // namespace plume
