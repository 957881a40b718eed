// What a method may be off by on a hard case, and whether it is: see known_failures.cpp for what is inherent.
#ifndef PLUME_STRESS_VERDICT_H
#define PLUME_STRESS_VERDICT_H

#include <span>
#include <string_view>

#include "renderer/methods/method.h"
#include "sandbox/stress/stress.h"

namespace plume {

/// A failure that a method has by what it is, with its size on this case, of 255 as pictures have them.
struct KnownFailure {
  std::string_view method, hard_case;
  double rmse, max;
  std::string_view why;
};
std::span<const KnownFailure> known_failures();

struct StressBound {
  double rmse, max;                     ///< relative, as StressFinding has them
  const KnownFailure* known = nullptr;  ///< null: what every method is held to
};
/// Exact methods are held to a thousandth of the brightest light and what they round, all others to 1/255 in
/// RMSE and 8/255 in any pixel, but where a failure is known: to a quarter more than its size.
StressBound bound_of(const StressCase& hard_case, const Method& method);

enum class Verdict {
  kPassed,
  kKnown,   ///< off by no more than what is known of it
  kFailed,  ///< off by more, or not finite
  kGone,    ///< what is known of it does not happen any more
  kUnavailable,
};
constexpr std::string_view kVerdictNames[] = {"passed", "known", "FAILED", "GONE", "unavailable"};
Verdict verdict_of(const StressCase& hard_case, const Method& method,
                   const std::optional<StressFinding>& finding);

}  // namespace plume
#endif
