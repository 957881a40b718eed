#include "sandbox/measure/statistics.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
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

}  // namespace
}  // namespace plume
