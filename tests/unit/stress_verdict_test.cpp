// What a finding on a hard case is taken for.
#include <gtest/gtest.h>

#include <set>

#include "renderer/methods/methods.h"
#include "sandbox/stress/verdict.h"

namespace plume {
namespace {

TEST(StressVerdict, GoesByTheBoundOfAll) {
  const StressCase hard{.id = "none", .title = "", .trouble = "", .pictures = {}};
  const auto verdict = [&](const char* method, double rmse, double max, bool finite = true) {
    return verdict_of(hard, *make_method(method),
                      StressFinding{.rmse = rmse / 255, .max = max / 255, .finite = finite});
  };
  EXPECT_EQ(verdict("avboit", 0.99, 7.9), Verdict::kPassed);
  EXPECT_EQ(verdict("avboit", 1.01, 7.9), Verdict::kFailed);
  EXPECT_EQ(verdict("avboit", 0.99, 8.1), Verdict::kFailed);
  EXPECT_EQ(verdict("avboit", 0.0, 0.0, false), Verdict::kFailed);
  EXPECT_EQ(verdict("avboit", 0.0, std::numeric_limits<double>::infinity()), Verdict::kFailed);
  EXPECT_EQ(verdict("peel", 0.0, 0.25), Verdict::kPassed);
  EXPECT_EQ(verdict("peel", 0.0, 0.27), Verdict::kFailed);
  EXPECT_EQ(verdict_of(hard, *make_method("avboit"), std::nullopt), Verdict::kUnavailable);
}

TEST(StressVerdict, OfWhatIsKnownIsOneOfThree) {
  const KnownFailure& known = known_failures().front();
  const StressCase hard{.id = std::string(known.hard_case), .title = "", .trouble = "", .pictures = {}};
  const auto verdict = [&](double times) {
    return verdict_of(hard, *make_method(known.method),
                      StressFinding{.rmse = times * known.rmse / 255, .max = times * known.max / 255});
  };
  EXPECT_EQ(verdict(1.0), Verdict::kKnown);
  EXPECT_EQ(verdict(1.2), Verdict::kKnown);
  EXPECT_EQ(verdict(1.3), Verdict::kFailed);
  EXPECT_EQ(verdict(0.0), Verdict::kGone);
}

TEST(StressVerdict, KnownFailuresAreOfMethodsAndCasesThatAreThere) {
  std::set<std::string_view> cases, methods;
  const std::vector<StressCase> all = stress_cases();
  for (const StressCase& hard : all) EXPECT_TRUE(cases.insert(hard.id).second) << hard.id;
  const std::vector<std::string> ids = method_ids();
  methods.insert(ids.begin(), ids.end());
  std::set<std::pair<std::string_view, std::string_view>> known;
  for (const KnownFailure& failure : known_failures()) {
    EXPECT_TRUE(methods.contains(failure.method)) << failure.method;
    EXPECT_TRUE(cases.contains(failure.hard_case)) << failure.hard_case;
    EXPECT_TRUE(known.insert({failure.method, failure.hard_case}).second)
        << failure.method << failure.hard_case;
    EXPECT_FALSE(failure.why.empty());
  }
}

}  // namespace
}  // namespace plume
