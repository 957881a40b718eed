#include "sandbox/runs/repetitions.h"

#include <gtest/gtest.h>

#include <vector>

namespace plume {
namespace {

TEST(RepetitionsTest, TwoMethodsTakeTurnsAsABBA) {
  std::vector<size_t> order;
  for (uint32_t repetition = 0; repetition < 4; ++repetition)
    for (size_t turn = 0; turn < 2; ++turn) order.push_back(whose_turn(turn, 2, repetition));
  EXPECT_EQ(order, (std::vector<size_t>{0, 1, 1, 0, 0, 1, 1, 0}));
}

TEST(RepetitionsTest, ADriftIsTheSameForAllOverAnEvenNumber) {
  for (const size_t count : {1u, 2u, 5u}) {
    std::vector<size_t> drift(count);
    for (uint32_t repetition = 0; repetition < 6; ++repetition)
      for (size_t turn = 0; turn < count; ++turn)
        drift[whose_turn(turn, count, repetition)] += repetition * count + turn;
    EXPECT_EQ(drift, std::vector<size_t>(count, drift.front())) << count;
  }
}

TEST(RepetitionsTest, ADriftIsToldFromTheHalves) {
  const std::vector<double> warming{10, 10.1, 10.2, 10.1, 12, 12.1, 12.2, 12.1};
  ASSERT_TRUE(drift(warming).has_value());
  EXPECT_NEAR(*drift(warming), 12.1 / 10.1, 1e-12);
}

TEST(RepetitionsTest, WhatIsNoDriftIsNotToldAsOne) {
  const std::vector<double> slight{10, 10.1, 10.2, 10.1, 10.3, 10.4, 10.5, 10.4},
      noisy{10, 13, 11, 12, 12, 14, 11, 13}, few{10, 10, 20, 20, 20};
  EXPECT_EQ(drift(slight), std::nullopt);
  EXPECT_EQ(drift(noisy), std::nullopt);
  EXPECT_EQ(drift(few), std::nullopt);
  EXPECT_EQ(drift({}), std::nullopt);
}

}  // namespace
}  // namespace plume
