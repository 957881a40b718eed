// What a scene's effects cost, summed up and written down.
#include "sandbox/effects/demand.h"

#include <gtest/gtest.h>

namespace plume {
namespace {

const std::vector<InstanceDemand> kInstances{{.name = "awake",
                                              .called = true,
                                              .awake = true,
                                              .why = "has 3 particles",
                                              .ticks_simulated = 1,
                                              .ticks_saved = 20,
                                              .dispatches = 300,
                                              .bytes = 4000,
                                              .bytes_saved = 50'000},
                                             {.name = "asleep",
                                              .called = true,
                                              .awake = false,
                                              .why = "out of view",
                                              .ticks_simulated = 2,
                                              .ticks_saved = 30,
                                              .dispatches = 400,
                                              .bytes = 5000,
                                              .bytes_saved = 60'000},
                                             {.name = "not called", .why = "not called"}};

TEST(Demand, TotalIsTheSumAndAwakeWhenAnyIs) {
  const InstanceDemand sum = total(kInstances);
  EXPECT_TRUE(sum.called);
  EXPECT_TRUE(sum.awake);
  EXPECT_EQ(3u, sum.ticks_simulated);
  EXPECT_EQ(50u, sum.ticks_saved);
  EXPECT_EQ(700u, sum.dispatches);
  EXPECT_EQ(9000u, sum.bytes);
  EXPECT_EQ(110'000u, sum.bytes_saved);
  EXPECT_FALSE(total({kInstances[1], kInstances[2]}).awake);
  EXPECT_FALSE(total({kInstances[2]}).called);
}

TEST(Demand, EveryInstanceSaysWhatItCostsAndWhy) {
  const nlohmann::json json = demand_json(kInstances);
  EXPECT_EQ(3u, json["instances"].size());
  EXPECT_EQ(nlohmann::json({{"name", "awake"},
                            {"called", true},
                            {"awake", true},
                            {"why", "has 3 particles"},
                            {"ticks_simulated", 1},
                            {"ticks_saved", 20},
                            {"dispatches", 300},
                            {"bytes", 4000},
                            {"bytes_saved", 50'000}}),
            json["instances"][0]);
  EXPECT_EQ(nlohmann::json({{"ticks_simulated", 3},
                            {"ticks_saved", 50},
                            {"dispatches", 700},
                            {"bytes", 9000},
                            {"bytes_saved", 110'000}}),
            json["total"]);
}

}  // namespace
}  // namespace plume
