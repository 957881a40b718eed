// The closed form of births against a walk tick by tick in exact rationals, over random schedules and paths.
#include "sandbox/effects/spawn_schedule.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <random>
#include <stdexcept>

namespace plume {
namespace {

__extension__ using Wide = unsigned __int128;

/// Nothing or a path with a context for it.
struct Course {
  std::optional<Path> path;
  SpawnContext context;
  explicit Course(std::optional<Path> p, SpawnContext c = {}) : path(std::move(p)), context(c) {
    context.path = path ? &*path : nullptr;
  }
  Course(const Course&) = delete;
};

/// The births of a path's ticks, segment by segment.
class WalkedPath {
 public:
  WalkedPath(const Path& path, double per_metre)
      : keys_(path.keys()), per_metre_(static_cast<uint64_t>(std::llround(per_metre * 1048576.0))) {}
  uint64_t step(uint32_t tick) {
    while (segment_ + 1 < keys_.size() && keys_[segment_ + 1].tick <= tick) {
      whole_ += length(segment_++);
      part_ = 0;
    }
    const bool under_way = segment_ + 1 < keys_.size() && tick >= keys_[segment_].tick;
    if (!under_way) return static_cast<uint64_t>(whole_ * per_metre_ >> 40);
    const uint32_t width = keys_[segment_ + 1].tick - keys_[segment_].tick;
    if (tick > keys_[segment_].tick) part_ += length(segment_);
    return static_cast<uint64_t>((whole_ * width + part_) * per_metre_ / (Wide{width} << 40));
  }

 private:
  uint64_t length(size_t i) const {
    const glm::dvec3 arm = glm::dvec3(keys_[i + 1].position) - glm::dvec3(keys_[i].position);
    return static_cast<uint64_t>(std::llround(std::sqrt(glm::dot(arm, arm)) * 1048576.0));
  }
  std::vector<Path::Key> keys_;
  uint64_t per_metre_;
  size_t segment_ = 0;
  Wide whole_ = 0, part_ = 0;  // 2^-20 m, the second times the segment's width
};

/// births(0), births(1), … births(last), added up one tick after another.
std::vector<uint64_t> walked_births(const Spawn& spawn, uint32_t last,
                                    const Course& course = Course(std::nullopt)) {
  std::optional<WalkedPath> walked_path;
  if (course.path) walked_path.emplace(*course.path, spawn.per_metre);
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
    const uint64_t from_way = walked_path ? walked_path->step(tick) : 0;
    births.push_back(from_bursts + from_way + static_cast<uint64_t>((whole * width + part) / (width << 21)));
    if (tick >= course.context.stop_tick) births.back() = tick == 0 ? 0 : births[tick - 1];
  }
  for (uint64_t& count : births) count *= course.context.per_root;
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

Course random_course(std::mt19937& random, Spawn& spawn) {
  const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  SpawnContext context;
  if (below(2)) context.stop_tick = below(700);
  if (below(2)) context.per_root = 1 + below(9), context.life = spawn.life_ticks.max + below(200);
  if (below(2)) return Course(std::nullopt, context);
  spawn.per_metre = std::pow(10.0, below(4)) / 10.0;
  std::vector<Path::Key> keys;
  const auto place = [&] { return static_cast<float>(below(1000)) / (below(2) ? 10.0f : 1000.0f); };
  for (uint32_t i = 0, tick = below(40), count = 2 + below(5); i < count;
       ++i, tick += 1 + below(i % 2 ? 3 : 150))
    keys.push_back({tick, {place(), place(), place()}});
  if (below(3) == 0) keys[1].position = keys[0].position;  // it may rest
  return Course(Path(std::move(keys)), context);
}

/// No schedule of random_spawn() and random_course() has a living particle after this.
constexpr uint32_t kEnd = 1700;

class RandomSchedules : public testing::Test {
 protected:
  template <class Check>
  void each(const Check& check) {
    std::mt19937 random(7);
    for (int i = 0; i < 600 && !HasFailure(); ++i) {
      SCOPED_TRACE(testing::Message() << "schedule " << i);
      Spawn spawn = random_spawn(random);
      const Course course = random_course(random, spawn);
      const SpawnSchedule schedule(spawn, course.context);
      check(spawn, course, schedule, walked_births(spawn, kEnd, course));
    }
  }
};

TEST_F(RandomSchedules, BirthsEqualTheSumTickByTick) {
  each([](const Spawn&, const Course&, const SpawnSchedule& schedule, const std::vector<uint64_t>& births) {
    for (uint32_t t = 0; t <= kEnd; ++t) ASSERT_EQ(schedule.births(t), births[t]) << "tick " << t;
    EXPECT_EQ(schedule.births_total(), births.back());
  });
}

TEST_F(RandomSchedules, BirthsNeverDecrease) {
  each([](const Spawn&, const Course&, const SpawnSchedule& schedule, const std::vector<uint64_t>&) {
    for (uint32_t t = 1; t <= kEnd; ++t)
      ASSERT_GE(schedule.births(t), schedule.births(t - 1)) << "tick " << t;
  });
}

TEST_F(RandomSchedules, BirthTickIsWhereTheCountPassesTheParticle) {
  each([](const Spawn&, const Course&, const SpawnSchedule& schedule, const std::vector<uint64_t>& births) {
    const uint64_t step = 1 + schedule.births_total() / 500;
    for (uint64_t k = 0; k < schedule.births_total(); k += step) {
      const auto first = std::ranges::upper_bound(births, k);
      ASSERT_EQ(schedule.birth_tick(k), first - births.begin()) << "particle " << k;
    }
    EXPECT_THROW(schedule.birth_tick(schedule.births_total()), std::out_of_range);
  });
}

TEST_F(RandomSchedules, CapacityHoldsTheLargestWindowAndHardlyMore) {
  int exact = 0;
  each([&](const Spawn& spawn, const Course& course, const SpawnSchedule& schedule,
           const std::vector<uint64_t>& births) {
    const uint32_t life = course.context.life.value_or(spawn.life_ticks.max);
    uint64_t largest = 0;
    for (uint32_t t = 0; t <= kEnd; ++t) {
      const uint64_t dead = t < life ? 0 : births[t - life];
      ASSERT_EQ(schedule.first_alive(t), dead) << "tick " << t;
      largest = std::max(largest, births[t] - dead);
    }
    EXPECT_GE(schedule.capacity(), largest);
    EXPECT_LE(schedule.capacity(), largest + 4 * course.context.per_root);
    exact += schedule.capacity() == largest;
  });
  EXPECT_GT(exact, 400);
}

TEST_F(RandomSchedules, TheLastTickIsTheLastWithALivingWindow) {
  each([](const Spawn&, const Course&, const SpawnSchedule& schedule, const std::vector<uint64_t>&) {
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
  // A rate of 1e9 that is reached after the stop, four billion ticks later.
  const SpawnSchedule schedule({.rate = {{0, 0.0}, {kLast, 1e9}}, .life_ticks = {1, UINT32_MAX}},
                               {.stop_tick = 1'000'000});
  const auto births = [](long double ticks) {
    return static_cast<double>(1e9L / 60 / kLast * ticks * ticks / 2);
  };
  EXPECT_NEAR(static_cast<double>(schedule.births_total()), births(1e6L), 1);
  EXPECT_NEAR(static_cast<double>(schedule.births(499'999)), births(5e5L), 1);
}

TEST(SpawnSchedule, MoreBirthsThanAnIndexHoldsAreRefusedWithTheirNumber) {
  const auto message = [](const Spawn& spawn, const SpawnContext& context) -> std::string {
    try {
      const SpawnSchedule schedule(spawn, context);
    } catch (const std::overflow_error& error) {
      return error.what();
    }
    return "";
  };
  const Spawn most{.bursts = {{0, 65535}}};
  EXPECT_EQ(message(most, {.per_root = 65537}), "");
  EXPECT_EQ(message(most, {.per_root = 65538}),
            "4295032830 particles are born in all, expected at most 4294967295");
  EXPECT_EQ(message(most, {.per_root = UINT64_MAX}).substr(0, 8), "12089073");
  EXPECT_NE(message({.rate = {{0, 1e9}, {UINT32_MAX, 1e9}}}, {}), "");
}

TEST(SpawnSchedule, BirthsByDistanceFollowTheWayAndNotTheTime) {
  // 3 m in 30 ticks, a rest of 70, 5 m in one tick.
  const Path path({{10, {0, 0, 0}}, {40, {3, 0, 0}}, {110, {3, 0, 0}}, {111, {3, 3, 4}}});
  const SpawnSchedule schedule({.life_ticks = {20, 20}, .per_metre = 4.0}, {.path = &path});
  EXPECT_EQ(schedule.births(10), 0u);
  EXPECT_EQ(schedule.births(12), 0u);
  EXPECT_EQ(schedule.births(13), 1u);  // 0.3 m
  EXPECT_EQ(schedule.births(40), 12u);
  EXPECT_EQ(schedule.births(110), 12u);
  EXPECT_EQ(schedule.births(111), 32u);
  EXPECT_EQ(schedule.births(UINT32_MAX), 32u);
  EXPECT_EQ(schedule.last_tick(), 130u);
  EXPECT_EQ(SpawnSchedule({.per_metre = 4.0}).births_total(), 0u);  // without a path
}

TEST(SpawnSchedule, StopsAtOnceAndWhatLivesGoesOn) {
  const Spawn spawn{.rate = {{0, 60.0}, {100, 60.0}}, .bursts = {{30, 7}}, .life_ticks = {10, 10}};
  const SpawnSchedule schedule(spawn, {.stop_tick = 30});
  EXPECT_EQ(schedule.births(29), 30u);
  EXPECT_EQ(schedule.births(30), 30u);  // the burst comes too late
  EXPECT_EQ(schedule.births_total(), 30u);
  EXPECT_EQ(schedule.first_alive(38), 29u);
  EXPECT_EQ(schedule.last_tick(), 38u);
  EXPECT_EQ(SpawnSchedule(spawn, {.stop_tick = 0}).births_total(), 0u);
}

TEST(SpawnSchedule, ChildrenAreCountedByTheirRoots) {
  const SpawnSchedule schedule({.bursts = {{5, 3}, {8, 1}}, .life_ticks = {2, 4}},
                               {.per_root = 6, .life = 10});
  EXPECT_EQ(schedule.births(5), 18u);
  EXPECT_EQ(schedule.births(8), 24u);
  EXPECT_EQ(schedule.birth_tick(17), 5u);
  EXPECT_EQ(schedule.birth_tick(18), 8u);
  EXPECT_EQ(schedule.first_alive(14), 0u);
  EXPECT_EQ(schedule.first_alive(15), 18u);
  EXPECT_EQ(schedule.capacity(), 24u);
  EXPECT_EQ(schedule.last_tick(), 17u);
}

TEST(SpawnSchedule, AScheduleOfDaysIsMadeInNoTime) {
  Spawn spawn{.rate = {{0, 10.0}}, .life_ticks = {600, 36'000}, .per_metre = 0.5};
  std::vector<Path::Key> keys;
  for (uint32_t i = 0; i < 1000; ++i) {
    const uint32_t tick = i * (kMaxTick / 1000);
    spawn.rate.push_back({tick + 5'000, i % 3 ? 20.0 : 5.0});
    spawn.bursts.push_back({tick + 7, 100});
    keys.push_back({tick, {i % 7, i % 5, i % 11}});
  }
  const Path path(std::move(keys));
  const auto processor_ms = [] {  // which other programs cannot add to
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * double(time.tv_sec) + 1e-6 * double(time.tv_nsec);
  };
  const double start = processor_ms();
  const SpawnSchedule schedule(spawn, {.path = &path});
  EXPECT_LT(processor_ms() - start, 50.0) << "a step for each tick takes longer";
  EXPECT_GT(schedule.births_total(), 3'000'000u);
  EXPECT_LT(schedule.capacity(), 15'000u);
}

TEST(SpawnSchedule, RejectsWhatTheReaderRejects) {
  EXPECT_THROW(SpawnSchedule({{{0, -1.0}, {1, 0.0}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{0, std::nan("")}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{0, 2e9}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{{3, 1.0}, {3, 1.0}}, {}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({{}, {{4, 1}, {4, 1}}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({.per_metre = -1.0}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({.per_metre = std::nan("")}), std::invalid_argument);
  EXPECT_THROW(SpawnSchedule({.per_metre = 2e6}), std::invalid_argument);
}

}  // namespace
}  // namespace plume
