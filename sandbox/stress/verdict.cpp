#include "sandbox/stress/verdict.h"

namespace plume {
namespace {

constexpr double kSlack = 1.25;  // of what is known: other devices round otherwise

StressBound asked_of_all(const Method& method) {
  const Traits traits = method.traits();
  if (traits.exact) return {.rmse = 1e-3 + traits.rounding, .max = 1e-3 + traits.rounding};
  return {.rmse = 1.0 / 255, .max = 8.0 / 255};
}

bool is_within(const StressFinding& finding, const StressBound& bound) {
  return finding.finite && finding.rmse <= bound.rmse && finding.max <= bound.max;
}

}  // namespace

StressBound bound_of(const StressCase& hard_case, const Method& method) {
  for (const KnownFailure& known : known_failures())
    if (known.method == method.id() && known.hard_case == hard_case.id)
      return {.rmse = kSlack * known.rmse / 255, .max = kSlack * known.max / 255, .known = &known};
  return asked_of_all(method);
}

Verdict verdict_of(const StressCase& hard_case, const Method& method,
                   const std::optional<StressFinding>& finding) {
  if (!finding) return Verdict::kUnavailable;
  const StressBound bound = bound_of(hard_case, method);
  if (!is_within(*finding, bound)) return Verdict::kFailed;
  if (!bound.known) return Verdict::kPassed;
  return is_within(*finding, asked_of_all(method)) ? Verdict::kGone : Verdict::kKnown;
}

}  // namespace plume
