// Every method on the hard cases, within its bounds: plume stress, with every tenth step of what has
// hundreds.
#include "sandbox/stress/verdict.h"
#include "tests/gpu/gpu_test.h"

namespace plume {
namespace {

class StressTest : public testing::WithParamInterface<std::string>, public GpuTest {
 protected:
  // With a thousand peels a picture, the layers would take minutes.
  StressTest() : GpuTest(GetParam() != "thousand_layers") {}
};

std::vector<std::string> case_ids() {
  std::vector<std::string> ids;
  for (const StressCase& hard : stress_cases()) ids.push_back(hard.id);
  return ids;
}

INSTANTIATE_TEST_SUITE_P(Cases, StressTest, testing::ValuesIn(case_ids()),
                         [](const auto& hard) { return hard.param; });

TEST_P(StressTest, EveryMethodStaysWithinItsBounds) {
  std::vector<StressCase> cases = stress_cases();
  StressCase& hard = *std::ranges::find(cases, GetParam(), &StressCase::id);
  if (hard.pictures.size() > 100) {
    std::vector<StressPicture> few;
    for (size_t i = 0; i < hard.pictures.size(); i += 10) few.push_back(std::move(hard.pictures[i]));
    hard.pictures = std::move(few);
  }
  std::vector<MethodRun> methods;
  for (const std::string& id : method_ids()) methods.push_back({.id = id, .settings = {}});
  const auto findings = StressRun(device, pipelines, library).run(hard, methods);
  for (size_t i = 0; i < methods.size(); ++i) {
    if (!findings[i]) continue;
    const auto method = make_method(methods[i].id);
    const Verdict verdict = verdict_of(hard, *method, findings[i]);
    const StressBound bound = bound_of(hard, *method);
    EXPECT_TRUE(verdict == Verdict::kPassed || verdict == Verdict::kKnown)
        << methods[i].id << ": " << kVerdictNames[size_t(verdict)] << ", RMSE " << 255 * findings[i]->rmse
        << " of " << 255 * bound.rmse << ", max " << 255 * findings[i]->max << " of " << 255 * bound.max
        << " in " << findings[i]->picture << " at " << findings[i]->pixel.x << "," << findings[i]->pixel.y;
  }
}

}  // namespace
}  // namespace plume
