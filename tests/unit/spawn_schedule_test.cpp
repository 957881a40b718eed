// The closed form of births against a walk tick by tick in exact rationals, over random schedules.
#include "sandbox/effects/spawn_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

namespace plume {
namespace {

__extension__ using Wide = unsigned __int128;

/// births(0), births(1), … births(last), added up one tick after another.
std::vector<uint64_t> walked_births(const Spawn& spawn, uint32_t last) {
  const auto fixed = [](double per_second) {
    return static_cast<uint64_t>(std::llround(per_second * 1048576.0 / 60.0));
  };
  std::vector<uint64_t> births;
  Wide whole = 0;  // twice the integral of the segments passed, in 2^-20 particles
  Wide part = 0;   // the same of this segment, times its width
  size_t segment = 0, burst = 0;
  uint64_t from_bursts = 0;
  for (uint32_t tick = 0; tick <= last; ++tick) {
    while (segment + 1 < spawn.rate.size() && spawn.rate[segment + 1].tick <= tick) {
      const uint32_t width = spawn.rate[segment + 1].tick - spawn.rate[segment].tick;
      EXPECT_TRUE(part % width == 0);
      whole += part / width;
      part = 0;
      ++segment;
    }
    Wide width = 1;
    if (segment + 1 < spawn.rate.size() && tick >= spawn.rate[segment].tick) {
      const auto &a = spawn.rate[segment], &b = spawn.rate[segment + 1];
      width = b.tick - a.tick;
      // The trapezium over [tick, tick + 1): twice its area is the sum of its ends.
      for (const Wide x : {Wide{tick} - a.tick, Wide{tick} + 1 - a.tick})
        part += fixed(a.per_second) * (width - x) + fixed(b.per_second) * x;
    }
    for (; burst < spawn.bursts.size() && spawn.bursts[burst].tick <= tick; ++burst)
      from_bursts += spawn.bursts[burst].count;
    births.push_back(from_bursts + static_cast<uint64_t>((whole * width + part) / (width << 21)));
  }
  return births;
}

Spawn random_spawn(std::mt19937& random) {
  const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  Spawn spawn;
  const double scale = std::pow(10.0, below(6)) / 10.0;
  for (uint32_t i = 0, tick = below(40), keys = below(6); i < keys; ++i, tick += 1 + below(i % 2 ? 3 : 200))
    spawn.rate.push_back({tick, below(4) ? scale * below(1000) / 999.0 : 0.0});
  for (uint32_t i = 0, tick = below(60), bursts = below(4); i < bursts; ++i, tick += 1 + below(90))
    spawn.bursts.push_back({tick, 1 + below(500)});
  spawn.life_ticks.min = 1 + below(20);
  spawn.life_ticks.max = spawn.life_ticks.min + below(below(2) ? 10 : 300);
  return spawn;
}

/// No schedule of random_spawn() has a living particle after this.
constexpr uint32_t kEnd = 1500;

class RandomSchedules : public testing::Test {
 protected:
  template <class Check>
  void each(const Check& check) {
    std::mt19937 random(7);
    for (int i = 0; i < 400 && !HasFailure(); ++i) {
      SCOPED_TRACE(testing::Message() << "schedule " << i);
      const Spawn spawn = random_spawn(random);
      check(spawn, SpawnSchedule(spawn), walked_births(spawn, kEnd));
    }
  }
};

TEST_F(RandomSchedules, BirthsEqualTheSumTickByTick) {
  each([](const Spawn&, const SpawnSchedule& schedule, const std::vector<uint64_t>& births) {
    for (uint32_t t = 0; t <= kEnd; ++t) ASSERT_EQ(schedule.births(t), births[t]) << "tick " << t;
    EXPECT_EQ(schedule.births_total(), births.back());
  });
}

TEST_F(RandomSchedules, BirthsNeverDecrease) {
  each([](const Spawn&, const SpawnSchedule& schedule, const std::vector<uint64_t>&) {
    for (uint32_t t = 1; t <= kEnd; ++t)
      ASSERT_GE(schedule.births(t), schedule.births(t - 1)) << "tick " << t;
  });
}

TEST_F(RandomSchedules, BirthTickIsWhereTheCountPassesTheParticle) {
  each([](const Spawn&, const SpawnSchedule& schedule, const std::vector<uint64_t>& births) {
    const uint64_t step = 1 + schedule.births_total() / 500;
    for (uint64_t k = 0; k < schedule.births_total(); k += step) {
      const auto first = std::ranges::upper_bound(births, k);
      ASSERT_EQ(schedule.birth_tick(k), first - births.begin()) << "particle " << k;
    }
    EXPECT_THROW(schedule.birth_tick(schedule.births_total()), std::out_of_range);
  });
}

TEST_F(RandomSchedules, CapacityIsTheLargestWindowAndNoLarger) {
  each([](const Spawn& spawn, const SpawnSchedule& schedule, const std::vector<uint64_t>& births) {
    uint64_t largest = 0;
    for (uint32_t t = 0; t <= kEnd; ++t) {
      const uint64_t dead = t < spawn.life_ticks.max ? 0 : births[t - spawn.life_ticks.max];
      ASSERT_EQ(schedule.first_alive(t), dead) << "tick " << t;
      largest = std::max(largest, births[t] - dead);
    }
    EXPECT_EQ(schedule.capacity(), largest);
  });
}

TEST_F(RandomSchedules, TheLastTickIsTheLastWithALivingWindow) {
  each([](const Spawn&, const SpawnSchedule& schedule, const std::vector<uint64_t>&) {
    const uint32_t last = schedule.last_tick();
    EXPECT_EQ(schedule.first_alive(last + 1), schedule.births_total());
    if (schedule.births_total() > 0) {
      EXPECT_LT(schedule.first_alive(last), schedule.births_total());
    }
  });
}

TEST(SpawnSchedule, ConstantRateGivesExactlyRateTimesDuration) {
  const SpawnSchedule schedule({{{0, 90.0}, {120, 90.0}}, {}, {30, 30}});
  EXPECT_EQ(schedule.births(0), 1u);  // 1.5 a tick
  EXPECT_EQ(schedule.births(1), 3u);
  EXPECT_EQ(schedule.births(118), 178u);
  EXPECT_EQ(schedule.births_total(), 180u);
  EXPECT_EQ(schedule.capacity(), 45u);
  EXPECT_EQ(schedule.last_tick(), 119u + 29u);
}

TEST(SpawnSchedule, BurstIsBornInItsTickAndLivesItsLife) {
  const SpawnSchedule schedule({{}, {{10, 7}, {12, 5}}, {2, 3}});
  EXPECT_EQ(schedule.births(9), 0u);
  EXPECT_EQ(schedule.births(10), 7u);
  EXPECT_EQ(schedule.births(12), 12u);
  EXPECT_EQ(schedule.first_alive(12), 0u);
  EXPECT_EQ(schedule.first_alive(13), 7u);  // born at 10, longest life 3: alive at 10, 11, 12
  EXPECT_EQ(schedule.capacity(), 12u);
  EXPECT_EQ(schedule.birth_tick(6), 10u);
  EXPECT_EQ(schedule.birth_tick(7), 12u);
  EXPECT_EQ(schedule.last_tick(), 14u);
}

TEST(SpawnSchedule, NothingBornTakesNoSpace) {
  for (const Spawn& spawn :
       {Spawn{}, Spawn{{{5, 100.0}}, {}, {60, 60}}, Spawn{{{0, 0.0}, {9, 0.0}}, {}, {60, 60}}}) {
    const SpawnSchedule schedule(spawn);
    EXPECT_EQ(schedule.births_total(), 0u);
    EXPECT_EQ(schedule.capacity(), 0u);
    EXPECT_EQ(schedule.last_tick(), 0u);
    EXPECT_EQ(schedule.births(UINT32_MAX), 0u);
  }
}

TEST(SpawnSchedule, TheHighestRatesAndTicksDoNotOverflow) {
  constexpr uint32_t kLast = UINT32_MAX - 1;
  Spawn spawn{{{0, 0.0}, {kLast, 1e9}}, {}, {1, 1}};
  // Walking four billion ticks for the capacity takes too long: ask for births only, by making the first
  // window the last.
  spawn.life_ticks.max = UINT32_MAX;
  const SpawnSchedule schedule(spawn);
  const long double total = 0.5L * 1e9L / 60.0L * kLast;
  EXPECT_NEAR(static_cast<double>(schedule.births_total() / total), 1.0, 1e-9);
  EXPECT_NEAR(static_cast<double>(schedule.births(kLast / 2) / total), 0.25, 1e-9);
}

TEST(SpawnSchedule, RejectsWhatTheReaderRejects) {
  EXPECT_THROW(SpawnSchedule({{{0, -1.0}, {1, 0.0}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{0, std::nan("")}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{0, 2e9}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{3, 1.0}, {3, 1.0}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{}, {{4, 1}, {4, 1}}, {1, 1}}), std::invalid_argument);
}

}  // namespace
}  // namespace plume
