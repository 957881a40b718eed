#include "sandbox/measure/statistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace plume {
namespace {

TEST(StatisticsTest, MedianOfAnOddCountIsTheMiddleValue) {
  const std::vector<double> values{9.0, 1.0, 4.0};
  EXPECT_EQ(summarise(values).median, 4.0);
}

TEST(StatisticsTest, MedianOfAnEvenCountIsTheMeanOfTheMiddleTwo) {
  const std::vector<double> values{8.0, 1.0, 100.0, 4.0};
  EXPECT_EQ(summarise(values).median, 6.0);
}

TEST(StatisticsTest, P95LiesBetweenTheNeighboursOfItsPosition) {
  std::vector<double> values(100);
  std::iota(values.begin(), values.end(), 1.0);
  EXPECT_DOUBLE_EQ(summarise(values).p95, 95.05);  // position 0.95 * 99 = 94.05 from the value 1
}

TEST(StatisticsTest, P95FallsOnAValueWhenItsPositionIsWhole) {
  std::vector<double> values(21);
  std::iota(values.begin(), values.end(), 0.0);
  EXPECT_DOUBLE_EQ(summarise(values).p95, 19.0);
}

TEST(StatisticsTest, OrderOfTheValuesDoesNotMatter) {
  const std::vector<double> ascending{1.0, 2.0, 3.0, 5.0, 8.0};
  const std::vector<double> shuffled{5.0, 1.0, 8.0, 3.0, 2.0};
  EXPECT_EQ(summarise(ascending).median, summarise(shuffled).median);
  EXPECT_EQ(summarise(ascending).p95, summarise(shuffled).p95);
  EXPECT_EQ(summarise(shuffled).min, 1.0);
}

TEST(StatisticsTest, OneValueIsEveryStatistic) {
  const std::vector<double> values{2.5};
  const Summary summary = summarise(values);
  EXPECT_EQ(summary.median, 2.5);
  EXPECT_EQ(summary.p95, 2.5);
  EXPECT_EQ(summary.min, 2.5);
  EXPECT_EQ(summary.samples, 1u);
}

TEST(StatisticsTest, SamplesAreCounted) {
  const std::vector<double> values(7, -1.0);
  const Summary summary = summarise(values);
  EXPECT_EQ(summary.samples, 7u);
  EXPECT_EQ(summary.min, -1.0);
}

TEST(StatisticsTest, NoValuesAreRefused) {
  EXPECT_THROW(summarise({}), std::invalid_argument);
}

TEST(StatisticsTest, ValuesThatAreNotFiniteAreRefused) {
  const std::vector<double> nan{1.0, std::numeric_limits<double>::quiet_NaN()};
  const std::vector<double> infinite{1.0, std::numeric_limits<double>::infinity()};
  EXPECT_THROW(summarise(nan), std::invalid_argument);
  EXPECT_THROW(summarise(infinite), std::invalid_argument);
}

TEST(StatisticsTest, IntervalOfFewValuesIsAllOfThem) {
  const std::vector<double> values{4.0, 1.0, 3.0, 2.0, 9.0};
  const Summary five = summarise(values), one = summarise(std::span(values).first(1));
  EXPECT_EQ(five.low, 1.0);
  EXPECT_EQ(five.high, 9.0);
  EXPECT_EQ(one.low, 4.0);
  EXPECT_EQ(one.high, 4.0);
}

/// Of 1 to n: so the ends of an interval are the places of the values that they are.
Summary of_first_numbers(size_t n) {
  std::vector<double> values(n);
  std::iota(values.begin(), values.end(), 1.0);
  return summarise(values);
}

TEST(StatisticsTest, IntervalIsWhatDrawingWithReplacementGives) {
  std::mt19937 random(7);
  for (const size_t n : {5u, 9u, 25u}) {
    std::vector<double> medians;
    for (int i = 0; i < 20'000; ++i) {
      std::vector<double> draws(n);
      for (double& draw : draws) draw = double(1 + random() % n);
      std::ranges::nth_element(draws, draws.begin() + long(n / 2));
      medians.push_back(draws[n / 2]);
    }
    std::ranges::sort(medians);
    EXPECT_EQ(of_first_numbers(n).low, medians[medians.size() / 40]) << n;
    EXPECT_EQ(of_first_numbers(n).high, medians[medians.size() - 1 - medians.size() / 40]) << n;
  }
}

TEST(StatisticsTest, IntervalOfManyValuesIsThatOfANormalDistribution) {
  // The median of many draws is normal with a deviation of sqrt(n) / 2 places: 1.96 of them to both sides.
  const Summary summary = of_first_numbers(100'000);
  const double reach = 1.96 * std::sqrt(100'000.0) / 2.0;
  EXPECT_NEAR(summary.low, 50'000.5 - reach, 2.0);
  EXPECT_NEAR(summary.high, 50'000.5 + reach, 2.0);
}

/// In how many of 4000 samples of n values the interval held the true median.
double coverage(size_t n, double true_median, const std::function<double(std::mt19937&)>& draw) {
  std::mt19937 random(11);
  constexpr int kTrials = 4000;
  int held = 0;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::vector<double> values(n);
    for (double& value : values) value = draw(random);
    const Summary summary = summarise(values);
    held += summary.low <= true_median && true_median <= summary.high;
  }
  return double(held) / kTrials;
}

TEST(StatisticsTest, IntervalHoldsTheTrueMedianAsOftenAsItSays) {
  const auto uniform = [](std::mt19937& r) { return double(r()) / 4294967296.0; };
  const auto with_spikes = [&](std::mt19937& r) {  // as timings are: a floor, and now and then much more
    const double u = uniform(r);
    return 10.0 - 0.1 * std::log(1.0 - u) + (u > 0.9 ? 50.0 * u : 0.0);
  };
  const auto cauchy = [&](std::mt19937& r) { return std::tan(M_PI * (uniform(r) - 0.5)); };  // no mean
  // 3.5 deviations of the share of 4000.
  for (const auto& [n, stated] : {std::pair(4, 0.875), {5, 0.9375}, {7, 0.875}, {25, 0.957}, {101, 0.954}}) {
    EXPECT_NEAR(coverage(size_t(n), 0.5, uniform), stated, n < 25 ? 0.02 : 0.012) << n;
    EXPECT_NEAR(coverage(size_t(n), 10.0 + 0.1 * std::log(2.0), with_spikes), stated, n < 25 ? 0.02 : 0.012)
        << n;
    EXPECT_NEAR(coverage(size_t(n), 0.0, cauchy), stated, n < 25 ? 0.02 : 0.012) << n;
  }
}

TEST(StatisticsTest, IntervalDoesNotDependOnTheOrder) {
  const std::vector<double> up{1, 2, 3, 4, 5, 6, 7, 8, 9}, mixed{9, 4, 2, 7, 1, 3, 8, 6, 5};
  EXPECT_EQ(summarise(up).low, summarise(mixed).low);
  EXPECT_EQ(summarise(up).high, summarise(mixed).high);
}

TEST(StatisticsTest, TellsApartOnlyWhatDoesNotMeet) {
  const std::vector<double> low{1, 2, 3, 4}, high{5, 6, 7, 8}, between{4, 4.5, 5, 6};
  EXPECT_TRUE(tells_apart(summarise(low), summarise(high)));
  EXPECT_TRUE(tells_apart(summarise(high), summarise(low)));
  EXPECT_FALSE(tells_apart(summarise(low), summarise(between)));  // they touch
  EXPECT_FALSE(tells_apart(summarise(low), summarise(low)));
}

TEST(StatisticsTest, FewValuesTellNothingApart) {
  const std::vector<double> low{1, 2, 3, 4}, high{51, 52, 53};
  EXPECT_FALSE(tells_apart(summarise(low), summarise(high)));
  EXPECT_FALSE(tells_apart(summarise(high), summarise(low)));
}

}  // namespace
}  // namespace plume
